// A question of one director to the others: would they mind?
#pragma once

#include <cstdint>
#include <optional>
#include <set>

namespace muster {

/// At most one question is open. Who does not answer in time agrees. Directors are ids of clients.
class WorldAsk {
public:
    static constexpr double kSeconds = 15.0;  ///< So long an answer is waited for [s].

    /// How a question ended.
    struct End {
        std::uint32_t asker = 0;
        std::uint32_t minds = 0;  ///< Who minds; 0: nobody.
    };

    /// A question to all of `others`; none may be open.
    void begin(std::uint32_t asker, std::set<std::uint32_t> others, double now);
    /// An answer; one to another question, or of somebody who is not asked, counts for nothing.
    void answer(std::uint32_t client, std::uint32_t number, bool allows);
    /// Somebody has left: nobody waits for them, and what they asked ends.
    void leave(std::uint32_t client);
    /// The asker does not want it any more.
    void withdraw(std::uint32_t client);
    /// The end of the question that is open, once: everybody allows it, somebody minds, or time is over.
    std::optional<End> end(double now);

    bool open() const { return asker_ != 0; }         ///< A question waits for answers.
    std::uint32_t asker() const { return asker_; }    ///< Who asks; 0 for nobody.
    std::uint32_t number() const { return number_; }  ///< Rises with each question.

private:
    std::uint32_t asker_ = 0;
    std::uint32_t minds_ = 0;
    std::uint32_t number_ = 0;
    double due_ = 0.0;                // When time is over [s].
    std::set<std::uint32_t> silent_;  // Who has not answered.
};

}  // namespace muster
