#include "studio/study/runs/forms.h"

#include <doctest.h>

#include <limits>
#include <set>

namespace muster {
namespace {

const Form& formOf(std::string_view instrument) {
    for (const Form& form : studyForms())
        if (form.instrument == instrument) return form;
    FAIL("no such form");
    return studyForms()[0];
}

StudyAnswer least(const Form& form, const Question& question) {
    StudyAnswer answer{form.perScheme ? "touch" : "", std::string(form.instrument),
                       std::string(question.name), "", question.low};
    if (!question.choices.empty()) answer.text = question.choices[0];
    return answer;
}

std::vector<StudyAnswer> leastOf(const Form& form) {
    std::vector<StudyAnswer> answers;
    for (const Question& question : form.questions) answers.push_back(least(form, question));
    return answers;
}

TEST_CASE("the instruments have as many items as published, on their scales") {
    CHECK(formOf("paper").questions.size() == 5);
    CHECK(formOf("sus").questions.size() == 10);
    CHECK(formOf("tlx").questions.size() == 6);
    CHECK(formOf("ueq-s").questions.size() == 8);
    CHECK(formOf("sus").questions[0].high == 5.0);
    CHECK(formOf("tlx").questions[0].high == 100.0);
    CHECK(formOf("ueq-s").questions[0].high == 7.0);
    CHECK(formOf("borg").questions[0].high == 10.0);
    for (const std::string_view name : {"sus", "tlx", "ueq-s", "borg"}) CHECK(!formOf(name).source.empty());
}

TEST_CASE("names of questions are unique, and complete answers are taken") {
    for (const Form& form : studyForms()) {
        std::set<std::string_view> names;
        for (const Question& question : form.questions) CHECK(names.insert(question.name).second);
        CHECK(checkForm(form, leastOf(form)).ok());
    }
}

TEST_CASE("missing, double and foreign answers are refused by name") {
    const Form& sus = formOf("sus");
    std::vector<StudyAnswer> answers = leastOf(sus);
    answers.pop_back();
    CHECK(checkForm(sus, answers).message().find("'sus-10' is not answered") != std::string::npos);
    answers = leastOf(sus);
    answers[1] = answers[0];
    CHECK(checkForm(sus, answers).message().find("'sus-1' is given twice") != std::string::npos);
    answers = leastOf(sus);
    answers[3].scheme = "mouse-paper";
    CHECK(checkForm(sus, answers).message().find("another control") != std::string::npos);
    CHECK(!checkForm(sus, leastOf(formOf("tlx"))).ok());
    std::vector<StudyAnswer> preference = leastOf(formOf("preference"));
    preference.pop_back();
    CHECK(checkForm(formOf("preference"), preference).ok());
}

TEST_CASE("answers outside their range, scale or choices are refused") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(checkAnswer({"touch", "borg", "arm", "", 0.5}).ok());
    for (const double number : {none, -0.5, 10.5, 0.25})
        CHECK(!checkAnswer({"touch", "borg", "arm", "", number}).ok());
    CHECK(!checkAnswer({"", "borg", "arm", "", 1.0}).ok());
    CHECK(!checkAnswer({"touch", "before", "age", "", 30.0}).ok());
    CHECK(!checkAnswer({"", "before", "age", "", 17.0}).ok());
    CHECK(!checkAnswer({"", "before", "hand", "third", none}).ok());
    CHECK(!checkAnswer({"", "before", "weight", "", 1.0}).ok());
    CHECK(!checkAnswer({"", "mood", "good", "", 1.0}).ok());
    CHECK(checkAnswer({"", "preference", "reasons", std::string(2000, 'a'), none}).ok());
    CHECK(!checkAnswer({"", "preference", "reasons", std::string(2001, 'a'), none}).ok());
}

}  // namespace
}  // namespace muster
