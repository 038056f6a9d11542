// Times, number of allocations and peak memory of the process.
#pragma once

#include <cstdint>
#include <vector>

namespace muster::scale {

/// Allocations so far by operator new, where the program counts them.
std::int64_t allocationCount();
/// True in a program that is linked with the counting allocator.
bool allocationsCounted();
/// Called by the counting allocator.
void countAllocation();

/// CPU time of this thread so far [ms].
double threadMilliseconds();
/// The least of the values that this share of them does not exceed; 0 for no values.
double quantile(std::vector<double> values, double share);

/// Resets the peak, where the system allows it.
void resetPeakMemory();
/// Most resident memory of the process since then [MB]; 0 where the system does not report it.
double peakMemory();
/// Resident memory of the process now [MB]; 0 where the system does not report it.
double residentMemory();

}  // namespace muster::scale
