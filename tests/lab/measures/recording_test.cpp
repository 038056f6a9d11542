// Files of trajectories.
#include "lab/measures/recording.h"

#include <doctest.h>

#include <string>

using namespace muster;

TEST_CASE("text as PedPy and JuPedSim write it") {
    const auto read = parseRecording(
        "\xEF\xBB\xBF# description: x\n#framerate: 16.00\n#ID FR X/cm Y/cm Z/cm ANGLE\n\n1 0 100 -200 0 45 "
        "\r\n"
        "2\t1\t150\t3e2\n",
        0.0);
    REQUIRE_MESSAGE(read.ok(), read.status().message());
    CHECK(read->trajectories.frameRate() == 16.0);
    REQUIRE(read->trajectories.all().size() == 2);
    CHECK(read->trajectories.all()[0].position == Vec2{1.0, -2.0});
    CHECK(read->trajectories.all()[1].position == Vec2{1.5, 3.0});
    CHECK(parseRecording("# framerate: 30 fps\n1 0 1 2 0\n").value().trajectories.frameRate() == 30.0);
    CHECK(parseRecording("1 0 1 2\n", 25.0).value().trajectories.frameRate() == 25.0);
    CHECK(parseRecording("1 0 1 2\n").status().message().find("framerate") != std::string::npos);
    const auto bad = parseRecording("# framerate: 10\n1 0 1 2\n1 1 one 2\n");
    CHECK(bad.status().code() == StatusCode::ParseError);
    CHECK(bad.status().message().find("line 3") != std::string::npos);
    CHECK_FALSE(parseRecording("# framerate: 10\n1 0 1\n").ok());
}

TEST_CASE("CSV as muster play writes it") {
    std::string text = "t,id,x,y,place_x,place_y\n";
    for (int f = 0; f < 500; ++f) {
        char line[80];
        std::snprintf(line, sizeof(line), "%.9g,7,%.9g,0.5,,\n", f / 60.0, f / 60.0);
        text += line;
    }
    const auto read = parseRecording(text);
    REQUIRE_MESSAGE(read.ok(), read.status().message());
    CHECK(read->trajectories.frameRate() == doctest::Approx(60.0).epsilon(1e-6));
    CHECK(read->trajectories.frameCount() == 500);
    CHECK(read->trajectories.all()[499].position.x == doctest::Approx(499 / 60.0));
    CHECK_FALSE(parseRecording("t,id,x,y\n0,1,2\n").ok());
}

TEST_CASE("files that are not there or hold something else") {
    CHECK(readRecording("/no/such/file").status().code() == StatusCode::IoError);
    CHECK_FALSE(parseRecording("").ok());
    CHECK_FALSE(parseRecording("{\"json\": 1}").ok());
}
