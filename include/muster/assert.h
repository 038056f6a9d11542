// Checks on the caller, active in debug and sanitizer builds.
#pragma once

#include <cstdio>
#include <cstdlib>

#if !defined(NDEBUG) || defined(MUSTER_ASSERTIONS)
#define MUSTER_ASSERT(condition)                                                                   \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            std::fprintf(stderr, "%s:%d: assertion failed: %s\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                          \
        }                                                                                          \
    } while (false)
#else
#define MUSTER_ASSERT(condition) ((void)0)
#endif
