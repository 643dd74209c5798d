/* SPDX-License-Identifier: MIT */

/* Turns of loops so far. A program that runs out of them says so, and the pixel is cast on the CPU. */
int csg_turns = 0;
