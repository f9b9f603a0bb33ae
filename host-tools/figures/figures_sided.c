/* host-tools/figures/figures_sided.c -- figures of patches with n sides and their coordinates
 * SPDX-License-Identifier: MIT
 */
#include "figures/figures.h"

/* A pentagon whose height is 40 times the coordinate of one vertex. */
#define ONE_VERTEX(kind)                                                                           \
    "spatch 5 1 " kind "\n"                                                                        \
    "domain 2.4492936e-15 40  -38.0422607 12.3606798  -23.5114101 -32.3606798  23.5114101 "        \
    "-32.3606798  38.0422607 12.3606798\n"                                                         \
    "2.4492936e-15 40 0\n-38.0422607 12.3606798 40\n-23.5114101 -32.3606798 0\n"                   \
    "23.5114101 -32.3606798 0\n38.0422607 12.3606798 0\n"

const figure figures_sided[] = {
    { "wachspress",
      "Polygons",
      "2.6.1, figure 2-8",
      "Lines of equal Wachspress coordinate of a vertex",
      ONE_VERTEX("wachspress"),
      NULL,
      NULL,
      "--contours 9 --view -90,90 {0}",
      "png",
      {
          { .says = "in the middle it is 1/5, of 40",
            .run = "eval --uv 0,0 {0}",
            .pick = "@1:3",
            .want = 8,
            .lsb = 3,
            .off = 1e-08 },
      } },
    { "meanvalue",
      "Polygons",
      "2.6.2, figure 2-9",
      "Lines of equal mean value coordinate of a vertex",
      ONE_VERTEX("meanvalue"),
      NULL,
      NULL,
      "--contours 9 --view -90,90 {0}",
      "png",
      {
          { .says = "in the middle it is 1/5, of 40",
            .run = "eval --uv 0,0 {0}",
            .pick = "@1:3",
            .want = 8,
            .lsb = 3,
            .off = 1e-08 },
      } },
    { "harmonic",
      "Polygons",
      "2.6.3, figure 2-10",
      "Lines of equal harmonic coordinate of a vertex",
      ONE_VERTEX("harmonic"),
      NULL,
      NULL,
      "--contours 9 --view -90,90 {0}",
      "png",
      {
          { .says = "in the middle it is 1/5, of 40",
            .run = "eval --uv 0,0 {0}",
            .pick = "@1:3",
            .want = 8,
            .lsb = 3,
            .off = 1e-08 },
      } },
    { "notch",
      "Polygons",
      "2.6.2",
      "Mean value coordinates in a polygon with a notch",
      "spatch 5 1 meanvalue\ndomain 0 0  40 0  40 30  20 10  0 30\n0 0 0\n"
      "40 0 0\n40 30 0\n20 10 30\n0 30 0\n",
      NULL,
      NULL,
      "--contours 9 --view -90,90 {0}",
      "png",
      {
          { .says = "the notch itself has 1, of 30",
            .run = "eval --uv 20,10 {0}",
            .pick = "@1:3",
            .want = 30,
            .lsb = 3 },
          { .says = "x is given back",
            .run = "eval --uv 20,5 {0}",
            .pick = "@1:1",
            .want = 20,
            .lsb = 3 },
          { .says = "y as well", .run = "eval --uv 20,5 {0}", .pick = "@1:2", .want = 5, .lsb = 3 },
      } },
    { "linear",
      "Polygons",
      "2.6, linear precision",
      "All three coordinates give 2 x + y back",
      "spatch 5 1 wachspress\n"
      "domain 0.5 0.95  0.0720245677 0.639057647  0.235496636 0.135942353  0.764503364 0.135942353 "
      " 0.927975432 0.639057647\n"
      "0.5 0.95 1.95\n0.0720245677 0.639057647 0.7831067824\n"
      "0.235496636 0.135942353 0.606935625\n"
      "0.764503364 0.135942353 1.664949081\n"
      "0.927975432 0.639057647 2.495008511\nspatch 5 1 meanvalue\n"
      "domain 0.5 0.95  0.0720245677 0.639057647  0.235496636 0.135942353  0.764503364 0.135942353 "
      " 0.927975432 0.639057647\n"
      "0.5 0.95 1.95\n0.0720245677 0.639057647 0.7831067824\n"
      "0.235496636 0.135942353 0.606935625\n"
      "0.764503364 0.135942353 1.664949081\n"
      "0.927975432 0.639057647 2.495008511\nspatch 5 1 harmonic\n"
      "domain 0.5 0.95  0.0720245677 0.639057647  0.235496636 0.135942353  0.764503364 0.135942353 "
      " 0.927975432 0.639057647\n"
      "0.5 0.95 1.95\n0.0720245677 0.639057647 0.7831067824\n"
      "0.235496636 0.135942353 0.606935625\n"
      "0.764503364 0.135942353 1.664949081\n"
      "0.927975432 0.639057647 2.495008511\n",
      "tensor 1 1\n0 0 0\n0 1 1\n1 0 2\n1 1 3\ntensor 1 1\n0 0 0\n0 1 1\n1 0 2\n1 1 3\n"
      "tensor 1 1\n0 0 0\n0 1 1\n1 0 2\n1 1 3\n",
      NULL,
      "--wire {0}",
      "png",
      {
          { .says = "the plane z = 2 x + y, in LSB",
            .run = "compare --with {9} {0}",
            .pick = "eval:5",
            .off = 4,
            .floats = 40 },
      } },
    { "s-patch-square",
      "Polygons",
      "3.1, (3-3); Triangles 6b",
      "An S-patch of depth 2 over a square is a biquadratic patch",
      "spatch 4 2\ndomain 0 0  32 0  32 32  0 32\n0 0 0\n20 0 15\n20 20 40\n"
      "0 20 20\n40 0 10\n40 20 5\n20 20 40\n40 40 25\n20 40 0\n0 40 5\n",
      "tensor 2 2\n0 0 0\n0 20 20\n0 40 5\n20 0 15\n20 20 40\n20 40 0\n40 0 10\n"
      "40 20 5\n40 40 25\n",
      NULL,
      "--control {0}",
      "png",
      {
          { .says = "the tensor patch, in LSB",
            .run = "compare --with {9} --part 0,0,0.03125,0.03125 {0}",
            .pick = "eval:5",
            .off = 3,
            .floats = 60 },
      } },
    { "toric-square",
      "Polygons",
      "3.2",
      "A toric patch over 2 by 2 with binomial coefficients is biquadratic",
      "toric\ndomain 0 0  2 0  2 2  0 2\n0 0 0 : 1 1\n20 0 15 : 1 2\n"
      "40 0 10 : 1 1\n0 20 20 : 1 2\n20 20 40 : 1 4\n40 20 5 : 1 2\n0 40 5 : 1 1\n"
      "20 40 0 : 1 2\n40 40 25 : 1 1\n",
      "tensor 2 2\n0 0 0\n0 20 20\n0 40 5\n20 0 15\n20 20 40\n20 40 0\n40 0 10\n"
      "40 20 5\n40 40 25\n",
      NULL,
      "--control {0}",
      "png",
      {
          { .says = "the tensor patch; x is rounded to 1/2 LSB of 2 mm, in LSB",
            .run = "compare --with {9} --part 0,0,0.5,0.5 {0}",
            .pick = "eval:5",
            .off = 25,
            .floats = 60 },
      } },
    { "spatch",
      "Polygons",
      "3.1; Triangles 6b",
      "An S-patch with five sides of depth 3",
      "spatch 5 3\n0 100 4.3755\n-9.5106 93.0902 6.264\n-5.8779 81.9098 12.301\n"
      "5.8779 81.9098 14.6124\n9.5106 93.0902 9.7171\n-19.0211 86.1803 3.2648\n"
      "-15.3884 75 7.7619\n-3.6327 75 14.7163\n0 86.1803 12.8773\n"
      "-11.7557 63.8197 10.1302\n-0 63.8197 15.6403\n3.6327 75 16.1881\n"
      "11.7557 63.8197 14.1085\n15.3884 75 12.2336\n19.0211 86.1803 7.7466\n"
      "-28.5317 79.2705 -0.7778\n-24.899 68.0902 1.3322\n"
      "-13.1433 68.0902 9.5651\n-9.5106 79.2705 11.007\n"
      "-21.2663 56.9098 2.5524\n-9.5106 56.9098 10.0416\n"
      "-5.8779 68.0902 13.993\n2.2451 56.9098 14.3011\n5.8779 68.0902 16.3044\n"
      "9.5106 79.2705 14.4601\n-17.6336 45.7295 1.1204\n-5.8779 45.7295 7.3636\n"
      "-2.2451 56.9098 13.3812\n5.8779 45.7295 9.675\n9.5106 56.9098 13.4947\n"
      "13.1433 68.0902 13.7867\n17.6336 45.7295 4.3605\n21.2663 56.9098 6.796\n"
      "24.899 68.0902 4.8246\n28.5317 79.2705 0.9106\n",
      NULL,
      NULL,
      "--control {0}",
      "png",
      {
          { .says = "a corner is a point of the net",
            .run = "eval --uv 0,1 {0}",
            .pick = "@1:3",
            .want = 4.3755,
            .lsb = 1,
            .off = 1e-05 },
          { .says = "the difference from f64, in LSB",
            .run = "compare --against f64 {0}",
            .pick = "eval:5",
            .off = 60,
            .floats = 60 },
      } },
    { "toric",
      "Polygons",
      "3.2",
      "A toric patch with six sides",
      "toric\ndomain 0 0  2 0  3 1  3 2  2 3  0 3\n42.5 44.5 -1.4635 : 1 1\n"
      "59.5 44.5 4.012 : 1 1\n76.5 44.5 6.2751 : 1 1\n42.5 61.5 0.4313 : 1 1\n"
      "59.5 61.5 14.398 : 1 4\n76.5 61.5 16.6611 : 1 4\n93.5 61.5 2.809 : 1 1\n"
      "42.5 78.5 0.4313 : 1 1\n59.5 78.5 14.398 : 1 4\n76.5 78.5 16.6611 : 1 4\n"
      "93.5 78.5 2.809 : 1 1\n42.5 95.5 -1.4635 : 1 1\n59.5 95.5 4.012 : 1 1\n"
      "76.5 95.5 6.2751 : 1 1\n",
      "toric\ndomain 0 0  2 0  3 1  3 2  2 3  0 3\n42.5 44.5 8 : 1 1\n"
      "59.5 44.5 8 : 1 1\n76.5 44.5 8 : 1 1\n42.5 61.5 8 : 1 1\n"
      "59.5 61.5 8 : 1 4\n76.5 61.5 8 : 1 4\n93.5 61.5 8 : 1 1\n"
      "42.5 78.5 8 : 1 1\n59.5 78.5 8 : 1 4\n76.5 78.5 8 : 1 4\n"
      "93.5 78.5 8 : 1 1\n42.5 95.5 8 : 1 1\n59.5 95.5 8 : 1 1\n"
      "76.5 95.5 8 : 1 1\n",
      NULL,
      "--control {0}",
      "png",
      {
          { .says = "the weights sum to 1: with all heights 8 it is flat, in LSB",
            .run = "compare --quadric=0,0,0,0,0,0,0,0,1,-8 {9}",
            .pick = "eval:5",
            .off = 0.51,
            .floats = 40 },
          { .says = "the difference from f64, in LSB",
            .run = "compare --against f64 {0}",
            .pick = "eval:5",
            .off = 60,
            .floats = 60 },
      } },
    { "basepoint",
      "Polygons",
      "3.3",
      "Base points: six sides of a quintic",
      "basepoint 5 2 2 2\n120.758 82.6 4.6915\n136 82.6 10.0882\n"
      "151.242 82.6 7.8779\n113.1369 69.4 1.9166\n128.379 69.4 9.3693\n"
      "143.621 69.4 11.4399\n158.8631 69.4 4.7495\n120.758 56.2 4.4783\n"
      "136 56.2 9.8111\n151.242 56.2 7.6647\n128.379 43 3.7583\n"
      "143.621 43 5.8289\n",
      "basepoint 5 2 2 2\n120.758 82.6 8\n136 82.6 8\n151.242 82.6 8\n"
      "113.1369 69.4 8\n128.379 69.4 8\n143.621 69.4 8\n158.8631 69.4 8\n"
      "120.758 56.2 8\n136 56.2 8\n151.242 56.2 8\n128.379 43 8\n143.621 43 8\n",
      NULL,
      "--control {0}",
      "png",
      {
          { .says = "the weights sum to 1: with all heights 8 it is flat, in LSB",
            .run = "compare --quadric=0,0,0,0,0,0,0,0,1,-8 {9}",
            .pick = "eval:5",
            .off = 0.51,
            .floats = 40 },
          { .says = "the difference from f64, in LSB",
            .run = "compare --against f64 {0}",
            .pick = "eval:5",
            .off = 1.01,
            .floats = 60 },
      } },
    { "ring",
      "Polygons",
      "3.4",
      "A Zheng-Ball patch with five sides",
      "ring 5 3\n0 30 4.3755\n9.5106 23.0902 6.9408\n-9.5106 23.0902 4.4743\n"
      "0 12.0601 10.2056\n-28.5317 9.2705 -0.7778\n-19.0211 16.1803 2.332\n"
      "-24.899 -1.9098 0.9516\n-11.4698 3.7268 7.5645\n"
      "-17.6336 -24.2705 1.1204\n-21.2663 -13.0902 1.8232\n"
      "-5.8779 -24.2705 5.2597\n-7.0888 -9.7568 8.7553\n"
      "17.6336 -24.2705 4.3605\n5.8779 -24.2705 6.9107\n"
      "21.2663 -13.0902 4.8543\n7.0888 -9.7568 10.7028\n28.5317 9.2705 0.9106\n"
      "24.899 -1.9098 3.4462\n19.0211 16.1803 5.5333\n11.4698 3.7268 10.3647\n",
      "ring 5 3\n0 30 8\n9.5106 23.0902 8\n-9.5106 23.0902 8\n0 12.0601 8\n"
      "-28.5317 9.2705 8\n-19.0211 16.1803 8\n-24.899 -1.9098 8\n"
      "-11.4698 3.7268 8\n-17.6336 -24.2705 8\n-21.2663 -13.0902 8\n"
      "-5.8779 -24.2705 8\n-7.0888 -9.7568 8\n17.6336 -24.2705 8\n"
      "5.8779 -24.2705 8\n21.2663 -13.0902 8\n7.0888 -9.7568 8\n"
      "28.5317 9.2705 8\n24.899 -1.9098 8\n19.0211 16.1803 8\n11.4698 3.7268 8\n",
      NULL,
      "--control {0}",
      "png",
      {
          { .says = "the weights sum to 1: with all heights 8 it is flat, in LSB",
            .run = "compare --quadric=0,0,0,0,0,0,0,0,1,-8 {9}",
            .pick = "eval:5",
            .off = 0.51,
            .floats = 40 },
          { .says = "the difference from f64, in LSB",
            .run = "compare --against f64 {0}",
            .pick = "eval:5",
            .off = 1.01,
            .floats = 60 },
      } },
};

const size_t figures_sideds = sizeof figures_sided / sizeof figures_sided[0];
