#include "studio/study/runs/forms.h"

#include <utility>

// SUS, NASA-TLX, UEQ-S and the CR10 scale are quoted verbatim with their sources; all else is our own
// wording.

namespace muster {
namespace {

using enum QuestionKind;

Question scale(std::string_view name, std::string_view text, std::string_view low, std::string_view high,
               double from = 1.0, double to = 5.0, double step = 1.0) {
    return {name, text, Scale, from, to, step, low, high, {}, true};
}
Question agree(std::string_view name, std::string_view text) {
    return scale(name, text, "Strongly disagree", "Strongly agree");
}
Question load(std::string_view name, std::string_view text, std::string_view low, std::string_view high) {
    return scale(name, text, low, high, 0.0, 100.0, 5.0);
}
Question pair(std::string_view name, std::string_view low, std::string_view high) {
    return scale(name, "", low, high, 1.0, 7.0);
}
Question number(std::string_view name, std::string_view text, double low, double high, bool needed = true) {
    return {name, text, Number, low, high, 1.0, {}, {}, {}, needed};
}
Question choice(std::string_view name, std::string_view text, std::vector<std::string_view> choices) {
    return {name, text, Choice, 0.0, 0.0, 1.0, {}, {}, std::move(choices), true};
}

Form consent() {
    return {"consent",
            "Taking part",
            "You will direct a small crowd by touch and by mouse, and answer questions; this takes about 40 "
            "minutes. We record your inputs, the times, and your answers. Your name is not recorded. You may "
            "stop at any time, without giving a reason. The data stay on this machine until whoever runs the "
            "study copies them.",
            "",
            false,
            {choice("agree", "I have read this, I am at least 18 years old, and I take part of my own will.",
                    {"yes"})}};
}

Form before() {
    return {"before",
            "About you",
            "",
            "",
            false,
            {number("age", "How old are you, in years?", 18, 120),
             choice("hand", "Which hand do you use?", {"right", "left", "both"}),
             number("game-hours", "How many hours a week do you play strategy games?", 0, 168),
             number("touch-hours", "How many hours a week do you use a touch screen?", 0, 168),
             choice("colour-vision", "Is your colour vision impaired?", {"no", "yes", "I do not know"}),
             number("mm-per-pixel", "Size of a pixel of the page, in millimetres", 0.02, 2.0)}};
}

Form paperLike() {
    return {"paper",
            "This control",
            "",
            "",
            true,
            {agree("learn", "It took me little time to learn this control."),
             agree("obey", "The crowd did what I wanted it to do."),
             agree("tired", "I could have gone on for a long time without effort."),
             agree("overview", "I kept the whole scene and the whole crowd in view."),
             agree("enjoy", "I liked to direct the crowd in this way.")}};
}

Form sus() {
    return {
        "sus",
        "Usability",
        "The system is the control that you have just used.",
        "Brooke, J. (1996). SUS: a quick and dirty usability scale.",
        true,
        {agree("sus-1", "I think that I would like to use this system frequently"),
         agree("sus-2", "I found the system unnecessarily complex"),
         agree("sus-3", "I thought the system was easy to use"),
         agree("sus-4",
               "I think that I would need the support of a technical person to be able to use this system"),
         agree("sus-5", "I found the various functions in this system were well integrated"),
         agree("sus-6", "I thought there was too much inconsistency in this system"),
         agree("sus-7", "I would imagine that most people would learn to use this system very quickly"),
         agree("sus-8", "I found the system very cumbersome to use"),
         agree("sus-9", "I felt very confident using the system"),
         agree("sus-10", "I needed to learn a lot of things before I could get going with this system")}};
}

Form tlx() {
    return {
        "tlx",
        "Workload",
        "",
        "Hart, S. G., & Staveland, L. E. (1988). Development of NASA-TLX; raw, without weights.",
        true,
        {load("mental", "Mental Demand: How mentally demanding was the task?", "Very Low", "Very High"),
         load("physical", "Physical Demand: How physically demanding was the task?", "Very Low", "Very High"),
         load("temporal", "Temporal Demand: How hurried or rushed was the pace of the task?", "Very Low",
              "Very High"),
         load("performance",
              "Performance: How successful were you in accomplishing what you were asked to do?", "Perfect",
              "Failure"),
         load("effort", "Effort: How hard did you have to work to accomplish your level of performance?",
              "Very Low", "Very High"),
         load("frustration",
              "Frustration: How insecure, discouraged, irritated, stressed, and annoyed were you?",
              "Very Low", "Very High")}};
}

Form ueq() {
    return {"ueq-s",
            "Impression",
            "",
            "Schrepp, M., Hinderks, A., & Thomaschewski, J. (2017). Short version of the User Experience "
            "Questionnaire (UEQ-S).",
            true,
            {pair("ueq-1", "obstructive", "supportive"), pair("ueq-2", "complicated", "easy"),
             pair("ueq-3", "inefficient", "efficient"), pair("ueq-4", "confusing", "clear"),
             pair("ueq-5", "boring", "exciting"), pair("ueq-6", "not interesting", "interesting"),
             pair("ueq-7", "conventional", "inventive"), pair("ueq-8", "usual", "leading edge")}};
}

Form borg() {
    return {"borg",
            "Tired arms",
            "",
            "Borg, G. (1998). Borg's perceived exertion and pain scales: the CR10 scale.",
            true,
            {scale("arm", "How tired is your arm?", "Nothing at all", "Extremely strong", 0.0, 10.0, 0.5)}};
}

Form preference() {
    return {"preference",
            "Which one?",
            "",
            "",
            false,
            {choice("preferred", "Which control would you choose if you had to go on?", {"touch", "mouse"}),
             {"reasons", "Why?", Text, 0.0, 0.0, 1.0, {}, {}, {}, false}}};
}

}  // namespace

std::span<const Form> studyForms() {
    static const std::vector<Form> forms{consent(), before(), paperLike(), sus(),
                                         tlx(),     ueq(),    borg(),      preference()};
    return forms;
}

}  // namespace muster
