// Requests of places: concurrent additions, expiry.
#include "engine/fields/geodesics/field_requests.h"

#include <doctest.h>

#include <thread>
#include <vector>

#include "base/archive.h"

using muster::FieldRequests;

TEST_CASE("a request expires when it is not repeated") {
    FieldRequests requests;
    requests.resize(3);
    requests.add(1);
    CHECK_FALSE(requests.active(0));
    for (int step = 0; step + 1 < FieldRequests::kLifetime; ++step) requests.age();
    CHECK(requests.active(1));
    requests.add(2);
    requests.age();
    CHECK_FALSE(requests.active(1));
    CHECK(requests.active(2));
    for (int step = 0; step + 1 < FieldRequests::kLifetime; ++step) requests.age(2);
    CHECK_FALSE(requests.active(2));
}

TEST_CASE("requests added by several threads at once are those added by one") {
    FieldRequests together;
    FieldRequests alone;
    together.resize(1000);
    alone.resize(1000);
    std::vector<std::thread> threads;
    for (std::int32_t t = 0; t < 4; ++t)
        threads.emplace_back([&together, t] {
            for (std::int32_t k = 0; k < 4000; ++k) together.add((k * (2 * t + 3)) % 700);
        });
    for (std::thread& thread : threads) thread.join();
    for (std::int32_t place = 0; place < 700; ++place) alone.add(place);
    for (std::size_t place = 0; place < 1000; ++place) CHECK(together.active(place) == alone.active(place));
}

TEST_CASE("an archive keeps requests with the steps left, and places added later have none") {
    FieldRequests requests;
    requests.resize(2);
    requests.add(0);
    requests.age();
    muster::Writer writer;
    requests.visit(writer);
    FieldRequests copy;
    muster::Reader reader(writer.bytes());
    copy.visit(reader);
    REQUIRE(reader.ok());
    REQUIRE(copy.size() == 2);
    copy.resize(3);
    CHECK_FALSE(copy.active(2));
    for (int step = 0; step + 2 < FieldRequests::kLifetime; ++step) copy.age();
    CHECK(copy.active(0));
    copy.age();
    CHECK_FALSE(copy.active(0));
}
