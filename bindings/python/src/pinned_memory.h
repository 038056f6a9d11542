// Keeps memory that Python looks at, when the engine gives it back.
//
// An array of the engine is a std::vector. Where the engine lets go of one while a view of Python lies in it,
// its block is kept until the last such view has gone. So a view never points to memory that is not there,
// whatever becomes of the world.
#pragma once

#include <cstddef>

namespace muster::python {

/// From now on the block in which `place` lies is not released, until unpin(). May be called several times.
void pin(const void* place);
/// Ends what one call of pin() began.
void unpin(const void* place);
/// Number of blocks that the engine has given back and that are kept; for tests.
std::size_t keptBlocks();

}  // namespace muster::python
