/* The C API of Muster: C99 and C++.
 *
 * Handles are ids, which functions check: a handle of something that was destroyed is refused and never read.
 * Structs with `structVersion` are made by their muster_default_...() function, never by hand; then fields
 * are set. Arrays are a pointer and a count, `positions` and `positionCount`; null with 0 is none. What is
 * handed to a function is copied. Texts are UTF-8 and end with a zero byte.
 *
 * Functions return MUSTER_OK or the code of a failure, whose sentence muster_last_error() gives. No function
 * throws, and none writes to what `out...` points to where it fails, but for handles, which become none.
 * Fields of kinds are small integers; other numbers than those listed are refused.
 *
 * Threads: different handles may be used at the same time, one handle by one thread at a time, for reading
 * too. Making and destroying is allowed from any thread. muster_set_allocator() and muster_set_log() belong
 * before everything else, while no other thread is in the library. Each thread has its own last error.
 *
 * The engine reads no clock in any decision. Only muster_world_stage_times() measures wall time.
 */
#ifndef MUSTER_MUSTER_H
#define MUSTER_MUSTER_H

#include "muster/c/bvh.h"
#include "muster/c/motion.h"
#include "muster/c/scenario.h"
#include "muster/c/take.h"
#include "muster/c/world.h"

#endif
