// Counts every way to ask for memory, in programs that counting_new.cpp is a part of.
#pragma once

#include <atomic>

/// Allocations of the whole program so far.
extern std::atomic<long> allocations;
