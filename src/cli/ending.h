/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_ENDING_H
#define CSG_CLI_ENDING_H

/*
 * Ended from outside: where SIGINT, SIGTERM or SIGHUP ends the process, its temporary folders go
 * first, and so does a line of progress on the terminal. Its children end with it
 * (common/process.h), and files that are not finished have no name (common/destination.h).
 */

/* To be called before any other thread is started, and again in a child made by fork. */
void csg_ending_begin(void);

/* Ends the process at once, all files being written: its memory and its context go with it, which
 * takes a tenth of what freeing them piece by piece does. */
_Noreturn void csg_ending_now(int code);

#endif
