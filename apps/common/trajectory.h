// Writes trajectories as CSV.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "muster/status.h"
#include "muster/world.h"

namespace muster {

/// Writes `t,id,x,y,place_x,place_y,group,heading,motion,goal`, one line per character and step: the place is
/// empty for unmatched characters, `group` is the id of the group, `heading` in radians, `motion` an index
/// into the world's clips, `goal` the id of the exit or waiting area that it goes to, 0 for none.
class TrajectoryWriter {
public:
    /// Creates the file and writes the header. Fails with IoError.
    static Result<TrajectoryWriter> create(const std::string& path);
    /// Adds a line per character.
    void add(const World& world);
    /// Closes the file. Fails with IoError where a write failed.
    Status close();

private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    TrajectoryWriter(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}

    std::unique_ptr<std::FILE, CloseFile> file_;
    std::string path_;
};

}  // namespace muster
