#include "studio/words/words.h"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/world/inspect.h"
#include "muster/views.h"
#include "studio/words/planner.h"
#include "studio/words/reader.h"

namespace muster {
using namespace words;

namespace {

constexpr std::size_t kMostCompletions = 8;

struct Replacer {
    GroupId standIn, group;

    void replace(GroupId& id) const {
        if (id == standIn) id = group;
    }
    void operator()(GiveOrder& give) const {
        replace(give.group);
        replace(give.order.group);
    }
    void operator()(MergeGroups& merge) const {
        for (GroupId& id : merge.groups) replace(id);
    }
    template <class Body>
    void operator()(Body& body) const {
        if constexpr (requires { replace(body.group); }) replace(body.group);
    }
};

/// Two groups cannot have one name, or nobody could tell them apart: parts get the next number that is free.
void nameParts(Understood& result, const World& world) {
    std::set<std::string> names;
    for (std::size_t g = 0; g < world.groupCount(); ++g) names.insert(std::string(world.group(g).name));
    for (const WordsPart& part : result.parts) {
        const auto g = inspect::indexOfGroup(world, part.from);
        const std::string whole(world.group(*g).name);
        const std::string made = whole + " 2";  // As the world calls it.
        std::string name = made;
        for (int k = 3; names.contains(name); ++k) name = whole + " " + std::to_string(k);
        names.insert(name);
        if (name == made) continue;
        ChangeGroup change;
        change.group = part.standIn;
        change.name = name;
        result.followers.emplace_back(std::move(change));
    }
}

Understood refused(std::string problem) {
    Understood result;
    result.problem = std::move(problem);
    return result;
}

}  // namespace

Understood understand(std::string_view text, const WordsScene& scene) {
    const KnownNames names(scene.world);
    Reading reading = words::Reader(text, names).read();
    if (!reading.problem.empty()) return refused(std::move(reading.problem));
    Understood result = Planner(scene, names).plan(reading.clauses);
    if (!result.problem.empty()) return refused(std::move(result.problem));
    nameParts(result, scene.world);
    return result;
}

void replaceStandIn(CommandBody& body, GroupId standIn, GroupId group) {
    std::visit(Replacer{standIn, group}, static_cast<CommandKinds&>(body));
}

std::vector<WordsCompletion> completions(std::string_view text, const WordsScene& scene) {
    const KnownNames names(scene.world);
    const std::vector<Token> tokens = tokensOf(text);
    const bool open = !tokens.empty() && tokens.back().end == text.size() && !tokens.back().number;
    const std::string start = open ? tokens.back().text : "";
    const std::string before(text.substr(0, open ? tokens.back().from : text.size()));
    std::vector<WordsCompletion> found;
    std::set<std::string> known;  // In small letters.
    const auto put = [&](const std::string& words) {
        if (found.size() == kMostCompletions || words.size() <= start.size()) return;
        std::string small = words;
        for (char& c : small) c = smallLetter(c);
        if (small.compare(0, start.size(), start) == 0 && known.insert(small).second)
            found.push_back({words, before + words + " "});
    };
    for (const Named& named : names.all()) put(named.name);
    if (text.empty() || open)
        for (const std::string_view phrase : commonPhrases()) put(std::string(phrase));
    // Behind a word that is whole no other is meant.
    const auto all = allWords();
    if (open && start.size() > 1 && std::find(all.begin(), all.end(), start) == all.end())
        for (const std::string_view word : all) put(std::string(word));
    return found;
}

}  // namespace muster
