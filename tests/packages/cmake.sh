#!/bin/bash
# tests/packages/cmake.sh -- add_subdirectory, FetchContent, find_package
# SPDX-License-Identifier: MIT
# usage: tests/packages/cmake.sh
row=cmake
. tests/packages/row.sh
needs cmake ninja
export CMAKE_GENERATOR=Ninja
said="64 points, 262144 -65536, loft $(version)"

# project FOLDER LINE..: a project of somebody else with a program per number type
project() {
    local folder=$work/$1; shift
    mkdir -p "$folder"
    cp tests/packages/user.c "$folder"
    {   echo 'cmake_minimum_required(VERSION 3.13)'
        echo 'project(user C)'
        printf '%s\n' "$@"
        echo 'foreach(num q16 f32 f64)'
        echo '    add_executable(user-${num} user.c)'
        echo '    target_link_libraries(user-${num} PRIVATE loft::${num}${KIND})'
        echo 'endforeach()'
    } > "$folder/CMakeLists.txt"
}
runs() {        # runs FOLDER OPTION..
    local folder=$work/$1; shift
    cmake -S "$folder" -B "$folder/build" "$@" && cmake --build "$folder/build" || return
    for num in q16 f32 f64; do
        [ "$("$folder/build/user-$num")" = "$said" ] || return
    done
}

project subdirectory "add_subdirectory(\"$top/lib\" loft)"
verdict "add_subdirectory(loft/lib): loft::q16 loft::f32 loft::f64, built and run" \
    runs subdirectory -DCMAKE_C_FLAGS="-Wall -Werror"
project fetched 'include(FetchContent)' \
    "FetchContent_Declare(loft SOURCE_DIR \"$top\" SOURCE_SUBDIR lib)" \
    'FetchContent_MakeAvailable(loft)'
sed -i 's/3.13/3.18/' "$work/fetched/CMakeLists.txt"
verdict "FetchContent with SOURCE_SUBDIR lib, built and run" runs fetched

installed() { make -s install-lib PREFIX=/usr DESTDIR="$work/moved" LIBDIR=/usr/lib/multi; }
verdict "make install-lib PREFIX=/usr DESTDIR=" installed
short=$(version | cut -d. -f1,2)
project found "find_package(loft $short CONFIG REQUIRED)"
patches() {     # patches NAME LINE OPTION..: a program of surfaces; LINE says where loft is
    local folder=$work/patches-$1 says=$2; shift 2
    mkdir -p "$folder" && cp lib/examples/grid.c "$folder" &&
        printf '%s\n' 'cmake_minimum_required(VERSION 3.13)' 'project(user C)' "$says" \
            'add_executable(user grid.c)' \
            'target_link_libraries(user PRIVATE loft::surfaces-q16)' > "$folder/CMakeLists.txt" &&
        cmake -S "$folder" -B "$folder/build" "$@" && cmake --build "$folder/build" &&
        "$folder/build/user" | grep -q '^  0.00  6.06  9.69'
}
verdict "add_subdirectory(loft/lib): loft::surfaces-q16, built and run" \
    patches subdirectory "add_subdirectory(\"$top/lib\" loft)"
verdict "find_package(loft-surfaces CONFIG): built and run" \
    patches found "find_package(loft-surfaces CONFIG REQUIRED)" \
        -Dloft_DIR="$work/moved/usr/lib/multi/cmake/loft" \
        -Dloft-surfaces_DIR="$work/moved/usr/lib/multi/cmake/loft-surfaces"
verdict "find_package(loft $short CONFIG) in the moved tree, shared: built and run" \
    runs found -Dloft_DIR="$work/moved/usr/lib/multi/cmake/loft"
project static "find_package(loft CONFIG REQUIRED)" 'set(KIND -static)'
verdict "find_package, loft::q16-static ..: built and run" \
    runs static -Dloft_DIR="$work/moved/usr/lib/multi/cmake/loft"
project later "find_package(loft 99.0 CONFIG REQUIRED)"
refused() {
    ! runs later -Dloft_DIR="$work/moved/usr/lib/multi/cmake/loft" > "$work/said" 2>&1 &&
        grep -q 'version: '"$(cd "$top" && version)" "$work/said"
}
verdict "find_package(loft 99.0) is refused, and the version named" refused
cross() {
    cmake -S "$top/lib" -B "$work/arm" -DCMAKE_SYSTEM_NAME=Generic -DLOFT_AXES=2 \
        -DCMAKE_C_COMPILER=arm-none-eabi-gcc -DCMAKE_C_COMPILER_WORKS=1 \
        -DCMAKE_C_FLAGS="-mcpu=cortex-m4 -mthumb -Os" && cmake --build "$work/arm" -t loft_q16 &&
        arm-none-eabi-nm "$work/arm/libloft_q16.a" | grep -q loft_bezier_eval_q16x2
}
verdict "cross: arm-none-eabi-gcc for the Cortex-M4, LOFT_AXES=2" cross
ended
