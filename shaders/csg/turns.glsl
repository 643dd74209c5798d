/* SPDX-License-Identifier: MIT */
/*
 * llvmpipe ends the loops of a fragment program after 65,535 turns, without a word, and counts them
 * for all the pixels that it draws at once: a turn that one of them takes counts for each, and the
 * end of a loop, also one that none of them enters, is a turn. So a
 * pixel counts no turns of its own, but for each look at the records the most that a pixel can take
 * (each, of csg_object). Where the next look may be one too many the program gives up, and the CPU
 * casts the pixel.
 */

int csg_turns = 0;

/* Counts a look. False: too few turns are left for it and one more, which finds the face. */
bool csg_may_look(int each)
{
    csg_turns += each;
    return csg_turns + each <= CSG_MAX_TURNS;
}

void csg_give_up()
{
    csg_turns = CSG_MAX_TURNS + 1;
}

bool csg_has_given_up(int each)
{
    return csg_turns + each > CSG_MAX_TURNS;
}
