// What all job arrays for Slurm have.
#pragma once

#include <cstddef>
#include <string>

namespace muster {

/// The first lines of a job array of so many tasks, each on one core. `about` are comments, each line with
/// its
/// "# " and its end.
inline std::string slurmHead(const std::string& about, const std::string& name, std::size_t tasks) {
    std::string text = "#!/bin/bash\n" + about;
    text += "#SBATCH --job-name=" + name + "\n";
    text += "#SBATCH --array=0-" + std::to_string(tasks - 1) + "\n";
    text +=
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task=1\n";
    return text;
}

}  // namespace muster
