// ports/packages/rust/loft-sys/build.rs -- bindgen's output for the installed libloft-q16
// SPDX-License-Identifier: MIT
// pkg-config says where loft is; the program bindgen is called, no other crate is needed.
use std::{env, path::PathBuf, process::Command};

fn words(program: &str, arguments: &[&str]) -> Vec<String> {
    let out = Command::new(program).args(arguments).output()
        .unwrap_or_else(|e| panic!("{program}: {e}"));
    assert!(out.status.success(), "{program}: {}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).unwrap().split_whitespace().map(String::from).collect()
}

fn main() {
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    let flags = words("pkg-config", &["--cflags", "loft-q16"]);
    for word in words("pkg-config", &["--libs", "loft-q16"]) {
        if let Some(folder) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={folder}");
        }
    }
    println!("cargo:rustc-link-lib=dylib=loft-q16");
    let header = out.join("all.h");
    std::fs::write(&header, "#include \"loft.h\"\n").unwrap();
    let status = Command::new("bindgen")
        .arg(&header).arg("-o").arg(out.join("bindings.rs"))
        .args(["--use-core", "--ctypes-prefix", "cty", "--allowlist-function", "loft_.*"])
        .args(["--allowlist-type", "loft_.*", "--allowlist-var", "LOFT_.*"])
        .args(["--default-enum-style", "consts", "--no-prepend-enum-name", "--"])
        .args(&flags).status().expect("bindgen");
    assert!(status.success());
}
