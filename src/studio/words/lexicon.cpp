#include "studio/words/lexicon.h"

#include <algorithm>
#include <array>

namespace muster::words {
namespace {

using Words = std::span<const std::string_view>;

struct VerbWords {
    Verb verb;
    std::string_view words;  // Phrases, separated by "|".
};

// Longer phrases win. A phrase has one to three words.
constexpr std::array kVerbs{
    VerbWords{Verb::Move,
              "go|goes|going|walk|walks|walking|run|runs|jog|move|moves|moving|march|marches|head|heads|come|"
              "comes|travel|proceed|proceeds|advance|advances|step|steps|send|bring|take|lead|put|place|rush|"
              "charge|retreat|return|stand|stands|gather|gathers|assemble|assembles|meet|meets|attack|"
              "go over|come over|go back|fall back|pull back|position|escort|enter|enters|visit|visits|"
              "relocate|direct|steer|get|wander|hurry|hurries|wants"},
    VerbWords{Verb::Walk, "keep walking|keep going|walk on|march on|keep marching|go straight on"},
    VerbWords{Verb::Face,
              "face|faces|facing|turn|turns|turning|look|looks|looking|rotate|rotates|turn to face|turns to "
              "face|turn towards|turn to"},
    VerbWords{Verb::Follow,
              "follow|follows|following|chase|chases|accompany|stay behind|stick with|go after|"
              "go with|shadow"},
    VerbWords{Verb::Guard,
              "guard|guards|guarding|protect|protects|defend|defends|surround|surrounds|encircle|watch over"},
    VerbWords{Verb::Leave,
              "leave|leaves|leaving|exit|exits|evacuate|evacuates|go home|get out|go out|move out|"
              "go outside|come out|vacate|escape|out"},
    VerbWords{
        Verb::Cross,
        "cross|crosses|swim|swims|climb|climbs|crawl|crawls|jump|jumps|hop|hops|vault|vaults|duck|ducks"},
    VerbWords{Verb::Wait, "wait|waits|waiting|queue|queues"},
    VerbWords{Verb::Stop,
              "stop|stops|halt|halts|cancel|abort|cease|stand down|drop everything|stop moving|"
              "stand still"},
    VerbWords{Verb::Hold,
              "hold|holds|stay|stays|freeze|remain|remains|hold position|hold ground|stay put|"
              "stay there|stay here|stays put|hold still|keep still|hold on|hold back|don't move|"
              "doesn't move|do not move"},
    VerbWords{Verb::Resume, "resume|resumes|continue|continues|carry on|go on|goes on|keep on"},
    VerbWords{Verb::Patrol, "patrol|patrols|patrolling|pace between|go back and|walk back and"},
    VerbWords{Verb::EndPatrol, "end patrol|stop patrolling|stops patrolling|stop patrol|end the patrol"},
    VerbWords{Verb::Form,
              "form|forms|forming|form up|make|makes|arrange|line up|lines up|reshape|"
              "become|becomes|take up|turn into|change to|switch to|shape|get into|stand in"},
    VerbWords{Verb::Space,
              "spread|spreads|spread out|spreads out|widen|loosen|loosen up|open up|tighten|"
              "tighten up|close up|closes up|close ranks|bunch up|squeeze|squeeze together|"
              "squash|narrow|move apart|move closer|spacing|move together|close in|fan out"},
    VerbWords{Verb::Split, "split|splits|divide|divides|split up|break up|break|separate|cut"},
    VerbWords{Verb::Merge,
              "merge|merges|join|joins|unite|combine|join up|join forces|rejoin|rejoins|reunite"},
    VerbWords{Verb::Swap,
              "swap|swaps|swap places|exchange places|change places|trade places|switch places|"
              "swap positions|exchange|swap sides"},
    VerbWords{Verb::Name, "name|rename|call|label"},
    VerbWords{Verb::Colour, "colour|color|paint|recolour|dye"},
    VerbWords{Verb::Faster,
              "faster|speed up|speeds up|go faster|walk faster|hurry up|quicker|hurries up|move faster|"
              "run faster|be quicker"},
    VerbWords{Verb::Slower, "slower|slow down|slows down|go slower|walk slower|move slower|walk more slowly"},
    VerbWords{Verb::Add, "add|insert"},
    VerbWords{Verb::Reverse, "reverse|reverses|reverse orders"},
    VerbWords{Verb::Skip, "skip|skips"},
    VerbWords{Verb::Play, "play|unpause|start|begin|go ahead"},
    VerbWords{Verb::Pause, "pause|pause it|pause time|freeze time|stop time|stop the clock"},
    VerbWords{Verb::Restart, "restart|start over|start again|reset|begin again|from the start"},
    VerbWords{Verb::Undo, "undo|undo that|take back|take that back|undo it|undo this|revert"},
    VerbWords{Verb::Redo, "redo|redo that|do it again|do again"},
    VerbWords{Verb::Pace, "speed|double speed|half speed|normal speed|slow motion|real time|full speed"},
};

constexpr std::array<std::string_view, 54> kFillers{
    "please", "now",  "the",      "a",        "an",          "let",   "let's",  "have",  "has",
    "tell",   "ask",  "make",     "can",      "could",       "would", "should", "shall", "will",
    "must",   "you",  "i",        "want",     "like",        "need",  "just",   "ok",    "okay",
    "hey",    "to",   "get",      "us",       "we",          "also",  "both",   "each",  "all",
    "so",     "that", "quickly",  "do",       "does",        "your",  "their",  "its",   "off",
    "up",     "over", "straight", "directly", "immediately", "there", "here",   "and",   "themselves"};

constexpr std::array<std::string_view, 12> kHeadings{"east",    "northeast", "north", "northwest",
                                                     "west",    "southwest", "south", "southeast",
                                                     "forward", "left",      "back",  "right"};

struct FormWord {
    std::string_view word;
    FormationKind kind;
};
constexpr std::array kForms{
    FormWord{"square", FormationKind::Square},
    FormWord{"block", FormationKind::Square},
    FormWord{"box", FormationKind::Square},
    FormWord{"grid", FormationKind::Square},
    FormWord{"rectangle", FormationKind::Square},
    FormWord{"phalanx", FormationKind::Square},
    FormWord{"line", FormationKind::Line},
    FormWord{"row", FormationKind::Line},
    FormWord{"rank", FormationKind::Line},
    FormWord{"ranks", FormationKind::Line},
    FormWord{"rows", FormationKind::Line},
    FormWord{"column", FormationKind::Column},
    FormWord{"file", FormationKind::Column},
    FormWord{"files", FormationKind::Column},
    FormWord{"snake", FormationKind::Column},
    FormWord{"wedge", FormationKind::Wedge},
    FormWord{"triangle", FormationKind::Wedge},
    FormWord{"arrow", FormationKind::Wedge},
    FormWord{"arrowhead", FormationKind::Wedge},
    FormWord{"vee", FormationKind::Wedge},
    FormWord{"v", FormationKind::Wedge},
    FormWord{"ring", FormationKind::Ring},
    FormWord{"circle", FormationKind::Circle},
    FormWord{"disc", FormationKind::Circle},
    FormWord{"disk", FormationKind::Circle},
    FormWord{"crescent", FormationKind::Crescent},
    FormWord{"semicircle", FormationKind::Crescent},
    FormWord{"half-circle", FormationKind::Crescent},
    FormWord{"half-moon", FormationKind::Crescent},
    FormWord{"arc", FormationKind::Crescent},
    FormWord{"horseshoe", FormationKind::Crescent},
    FormWord{"pacman", FormationKind::Pacman},
    FormWord{"pac-man", FormationKind::Pacman},
};

bool isIn(Words words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

template <class Each>
void eachPhrase(std::string_view phrases, const Each& each) {
    while (!phrases.empty()) {
        const std::string_view phrase = phrases.substr(0, phrases.find('|'));
        each(phrase);
        phrases.remove_prefix(std::min(phrases.size(), phrase.size() + 1));
    }
}

std::vector<std::string_view> collectWords() {
    std::vector<std::string_view> words{
        "everybody", "everyone", "others", "rest",   "half",  "third",  "quarter", "people",  "group",
        "between",   "around",   "beside", "behind", "front", "middle", "centre",  "nearest", "metres",
        "seconds",   "spacing",  "apart",  "facing", "then",  "except", "toward",  "towards", "slowly"};
    for (const VerbWords& verb : kVerbs)
        eachPhrase(verb.words, [&](std::string_view phrase) {
            if (phrase.find(' ') == std::string_view::npos) words.push_back(phrase);
        });
    for (const std::string_view heading : kHeadings) words.push_back(heading);
    for (const FormWord& form : kForms) words.push_back(form.word);
    return words;
}

}  // namespace

std::size_t matches(std::span<const Token> tokens, std::string_view phrase) {
    std::size_t words = 0;
    while (!phrase.empty()) {
        const std::string_view word = phrase.substr(0, phrase.find(' '));
        if (words == tokens.size() || tokens[words].text != word) return 0;
        ++words;
        phrase.remove_prefix(std::min(phrase.size(), word.size() + 1));
    }
    return words;
}

VerbFound verbAt(std::span<const Token> tokens) {
    VerbFound found;
    for (const VerbWords& verb : kVerbs)
        eachPhrase(verb.words, [&](std::string_view phrase) {
            const std::size_t words = matches(tokens, phrase);
            if (words > found.words) found = {verb.verb, words};
        });
    return found;
}

bool isFiller(std::string_view word) {
    return isIn(kFillers, word);
}

std::optional<Heading> headingOf(std::string_view word) {
    for (std::size_t k = 0; k < kHeadings.size(); ++k)
        if (kHeadings[k] == word) return static_cast<Heading>(k);
    constexpr std::array<std::pair<std::string_view, Heading>, 22> kOthers{
        {{"north-east", Heading::NorthEast}, {"north-west", Heading::NorthWest},
         {"south-east", Heading::SouthEast}, {"south-west", Heading::SouthWest},
         {"northwards", Heading::North},     {"southwards", Heading::South},
         {"eastwards", Heading::East},       {"westwards", Heading::West},
         {"northward", Heading::North},      {"southward", Heading::South},
         {"eastward", Heading::East},        {"westward", Heading::West},
         {"forwards", Heading::Forward},     {"ahead", Heading::Forward},
         {"backward", Heading::Back},        {"backwards", Heading::Back},
         {"northern", Heading::North},       {"southern", Heading::South},
         {"eastern", Heading::East},         {"western", Heading::West},
         {"upwards", Heading::North},        {"downwards", Heading::South}}};
    for (const auto& [other, heading] : kOthers)
        if (other == word) return heading;
    return std::nullopt;
}

std::optional<FormationKind> formOf(std::string_view word) {
    for (const FormWord& form : kForms)
        if (form.word == word) return form.kind;
    return std::nullopt;
}

std::optional<double> shareOf(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, double>, 12> kShares{{{"half", 0.5},
                                                                           {"halves", 0.5},
                                                                           {"third", 1.0 / 3.0},
                                                                           {"thirds", 1.0 / 3.0},
                                                                           {"quarter", 0.25},
                                                                           {"quarters", 0.25},
                                                                           {"fourth", 0.25},
                                                                           {"fifth", 0.2},
                                                                           {"fifths", 0.2},
                                                                           {"sixth", 1.0 / 6.0},
                                                                           {"tenth", 0.1},
                                                                           {"tenths", 0.1}}};
    for (const auto& [share, value] : kShares)
        if (share == word) return value;
    return std::nullopt;
}

std::optional<double> metresOf(std::string_view word) {
    constexpr std::array<std::string_view, 8> kMetres{"m",      "metre", "metres", "meter",
                                                      "meters", "step",  "steps",  "paces"};
    if (isIn(kMetres, word)) return 1.0;
    if (word == "foot" || word == "feet" || word == "ft") return 0.3048;
    return std::nullopt;
}

bool isPeopleWord(std::string_view word) {
    constexpr std::array<std::string_view, 14> kPeople{
        "people",  "persons",  "person", "men",      "soldiers", "characters", "agents",
        "members", "students", "kids",   "children", "dancers",  "units",      "extras"};
    return isIn(kPeople, word);
}

bool isEverybody(std::string_view word) {
    constexpr std::array<std::string_view, 5> kEverybody{"everybody", "everyone", "all", "crowd", "nobody"};
    return isIn(kEverybody, word);
}

bool isRest(std::string_view word) {
    constexpr std::array<std::string_view, 6> kRest{"rest",      "others", "remainder",
                                                    "remaining", "other",  "else"};
    return isIn(kRest, word);
}

bool isGroupWord(std::string_view word) {
    constexpr std::array<std::string_view, 14> kGroup{"group", "groups", "team",  "teams", "ones",
                                                      "unit",  "units",  "squad", "side",  "people",
                                                      "lot",   "crowd",  "guys",  "one"};
    return isIn(kGroup, word);
}

std::span<const std::string_view> allWords() {
    static const std::vector<std::string_view> kWords = collectWords();
    return kWords;
}

std::span<const std::string_view> commonPhrases() {
    static constexpr std::array<std::string_view, 16> kPhrases{
        "go to", "form a ring",    "in a ring", "in a line", "face",      "follow",  "guard",  "hold",
        "stop",  "patrol between", "leave",     "the rest",  "everybody", "half of", "facing", "then"};
    return kPhrases;
}

std::string_view nameOf(Heading heading) {
    return kHeadings[static_cast<std::size_t>(heading)];
}

}  // namespace muster::words
