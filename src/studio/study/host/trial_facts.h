// What a page learns of a trial and of a form.
#pragma once

#include "studio/session/inbox/protocol.h"
#include "studio/study/runs/forms.h"
#include "studio/study/runs/plan.h"
#include "studio/study/store/records.h"

namespace muster {

/// Fills in what a trial is of: environment, control, items, limit.
void describeTrial(const TrialDef& def, protocol::StudyState& state);
/// How a stored trial ended.
protocol::TrialEnd endOf(const StudyTrial& trial);
/// A form as a message; `scheme` is the control that it is about, or empty.
protocol::StudyForm formOf(const Form& form, const std::string& scheme);
/// The answers of a message, about that control.
std::vector<StudyAnswer> answersOf(const protocol::AnswerForm& message, const std::string& scheme);

}  // namespace muster
