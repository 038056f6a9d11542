// The commands of muster-lab: `muster` knows their names, and muster-lab carries them out.
#pragma once

namespace muster {

/// What a command is called, and one sentence about it.
struct LabCommand {
    const char* name;
    const char* about;
};

inline constexpr LabCommand kPictureCommand{"picture", "Draws a moment of a scenario or take."};
inline constexpr LabCommand kPeersCommand{
    "peers", "Runs scenes with explicit starts and slots, as other crowd engines do."};
inline constexpr LabCommand kMotionCommand{"motion", "Lengths, speeds and contacts of motion clips."};
inline constexpr LabCommand kReproduceCommand{"reproduce",
                                              "Runs the paper's experiments and writes a report."};
inline constexpr LabCommand kSweepCommand{"sweep",
                                          "Runs the paper's experiments with several values of a parameter."};
inline constexpr LabCommand kVerifyCommand{"verify", "Runs the standard tests of pedestrian dynamics."};
inline constexpr LabCommand kMeasureCommand{"measure",
                                            "Flow, density and speed from a file of trajectories."};
inline constexpr LabCommand kLabCommands[] = {kPictureCommand,   kPeersCommand, kMotionCommand,
                                              kReproduceCommand, kSweepCommand, kVerifyCommand,
                                              kMeasureCommand};

// Commands of `muster study` that need no person.
inline constexpr LabCommand kStudyModelsCommand{"models", "Runs trials of operator models and keeps them."};
inline constexpr LabCommand kStudyReportCommand{"report", "Writes report.html and results.json."};
inline constexpr LabCommand kStudyExportCommand{"export", "Writes all tables as CSV, with a codebook."};
inline constexpr LabCommand kLabStudyCommands[] = {kStudyModelsCommand, kStudyReportCommand,
                                                   kStudyExportCommand};

}  // namespace muster
