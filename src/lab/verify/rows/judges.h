// Judges that several tests share.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/verify/row.h"
#include "lab/verify/rows/references.h"

namespace muster {

using JudgeRow = std::function<void(const VerifySamples&, RowReport&)>;

/// The time over 40 m from rest, between two limits.
JudgeRow judgeFromRest(const std::string& variant, double low, double high);
/// The mean speed over the measured length, within 5 % of the set speed [own].
JudgeRow judgeSpeed(const std::string& variant, double length, double speed);
/// Everybody sets out within half a second of the assigned time [own].
JudgeRow judgeStarts();
/// First movements of all seeds fit each distribution: Kolmogorov and Smirnov, p above 0.05 [own].
JudgeRow judgeStartDistributions(const std::vector<std::pair<std::string, Distribution>>& spreads);
/// All 20 are round the corner and nobody was in a wall by more than a millimetre.
JudgeRow judgeCorner(const std::string& variant);
/// Free speeds fit a distribution; mean and deviation where they are given.
JudgeRow judgeSpeeds(const std::string& variant, const Distribution& spread, bool meanAndDeviation);
/// The time of the last person to cross rises from each case to the next.
JudgeRow judgeCounterflow();
/// Two doors take about twice as long as four [own: 1.6 to 2.4].
JudgeRow judgePublicRoom();
/// 15 leave by the main exit, 8 by the second one, as assigned.
JudgeRow judgeCabins();
/// The flow over the whole period is at most 1.33 /s with the exit's rate; the flow without it is shown.
JudgeRow judgeExitFlow();
/// A jam at the door of the room, another at the foot of the stairs, fewer people between.
JudgeRow judgeStairJam(const std::string& variant, bool grows);
/// The first group is out within 10 s.
JudgeRow judgeGroups(const std::string& variant);
/// With the slow person it takes longer.
JudgeRow judgeSlowOne();
/// The share of the second exit rises with a third person who takes it.
JudgeRow judgeSocial();
/// Without a preference both exits are used alike [own: by 20 % of seeds], with it the preferred one wins.
JudgeRow judgeAffiliation();
/// The person whose exit is shut leaves by the other one.
JudgeRow judgeDynamicExit();

/// The words of a row of a suite.
RowDef rowOf(const std::string& suite, const std::string& number, const std::string& title,
             const std::string& setup, const std::string& expected, const std::string& source);
/// A row that is run in a scene: its variants, its seeds, the seeds of the short set, and its judge.
RowDef runIn(RowDef row, const std::string& scene, std::vector<std::string> variants, std::int32_t seeds,
             std::int32_t briefSeeds, JudgeRow judge);
/// A row that cannot be run.
RowDef missingRow(const std::string& suite, const std::string& number, const std::string& title,
                  const std::string& expected, const std::string& why);
/// A plot of N-t curves of the first seed of some variants.
VerifyPlot curvesPlot(const VerifySamples& samples, const std::vector<std::string>& variants,
                      const std::string& curve, const std::string& title);

}  // namespace muster
