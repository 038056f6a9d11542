// Requests for cost fields, made by concurrent queries and served in a later phase.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace muster {

/// Stores a value that several threads may store at once, with no order among them. Nobody may read the
/// variable meanwhile.
template <class T>
void storeRelaxed(T& variable, T value) {
#ifdef __cpp_lib_atomic_ref
    std::atomic_ref<T>(variable).store(value, std::memory_order_relaxed);
#else
    // The standard library of the WebAssembly build has no std::atomic_ref.
    __atomic_store_n(&variable, value, __ATOMIC_RELAXED);
#endif
}

/// One request per place. In the query phase several threads add requests at once and nobody reads them; in
/// the update phase one thread reads them and lets them expire. A request expires when it has not been
/// repeated for kLifetime steps.
class FieldRequests {
public:
    static constexpr std::uint8_t kLifetime = 60;  ///< Steps until a request expires.

    /// Sets the number of places; places that are added have no request.
    void resize(std::size_t places) { stepsLeft_.resize(places, 0); }
    /// Number of places.
    std::size_t size() const { return stepsLeft_.size(); }
    /// Requests the fields of a place, or renews the request. May be called from several threads.
    void add(std::int32_t place) { storeRelaxed(stepsLeft_[place], kLifetime); }
    /// True where the request of a place has not expired.
    bool active(std::size_t place) const { return stepsLeft_[place] > 0; }
    /// Ages all requests by one step.
    void age() {
        for (std::uint8_t& left : stepsLeft_) left = static_cast<std::uint8_t>(left - (left > 0 ? 1 : 0));
    }
    /// Ages the active request of one place by one step.
    void age(std::size_t place) { --stepsLeft_[place]; }

    /// Lets an archive read or write the requests.
    template <class Archive>
    void visit(Archive& archive) {
        archive(stepsLeft_);
    }

private:
    std::vector<std::uint8_t> stepsLeft_;  // Per place: steps until its request expires, 0 for none.
};

}  // namespace muster
