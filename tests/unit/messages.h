/* SPDX-License-Identifier: MIT */
#ifndef CSG_TESTS_MESSAGES_H
#define CSG_TESTS_MESSAGES_H

/* What a log has been told. */

#include <stdio.h>

#include "common/log.h"

struct messages {
    size_t num;
    char last[4096];
};

static void keep_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                         const char *text)
{
    struct messages *messages = user;
    (void)level;
    (void)id;
    messages->num++;
    snprintf(messages->last, sizeof messages->last, "%s", text);
}

#endif
