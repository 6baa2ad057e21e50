// SPDX-License-Identifier: GPL-3.0-or-later
// H-10, H-11, U-15: a machine file that is damaged, hostile or of another kind is refused as a whole, and the
// problem names the line and the field. Lines are counted by hand.
#include <gtest/gtest.h>

#include <string>

#include "model/machinefile/machinefile.h"
#include "tests/model/machines.h"

namespace nmc {
namespace {

using FileFault = FileProblem::Kind;
using Wanted = FileProblem::Wanted;

FileProblem problemOf(const std::string& text) {
    const auto parsed = parseMachine(text);
    EXPECT_FALSE(parsed.has_value()) << text;
    return parsed ? FileProblem{.line = -1} : parsed.error();
}

/// A file with `line` as its third line.
std::string fileWith(const std::string& line) {
    return "{\"format\": \"nmc-panel-machine\",\n\"version\": 1,\n" + line + "\n}\n";
}
/// A file with one axis, and `line` as its fourth line.
std::string axisWith(const std::string& line) {
    return fileWith("\"axes\": [{\n" + line + "\n}]");
}

TEST(BadMachineFile, CutAtAnyByteItIsRefusedAsTruncatedInTheLineWhereItEnds) {
    const std::string whole = writeMachine(testing_support::taughtMill());
    ASSERT_TRUE(parseMachine(whole).has_value());
    int line = 1;      // of the last character that is not a blank
    int nextLine = 1;  // of the next character
    for (std::size_t length = 1; length + 1 < whole.size(); ++length) {
        const char last = whole[length - 1];
        if (last == '\n')
            ++nextLine;
        else if (last != ' ')
            line = nextLine;
        const FileProblem problem = problemOf(whole.substr(0, length));
        ASSERT_EQ(problem.kind, FileFault::Truncated) << "after " << length << " bytes";
        ASSERT_EQ(problem.line, line) << "after " << length << " bytes";
    }
}

TEST(BadMachineFile, NothingIsThere) {
    EXPECT_EQ(problemOf("").kind, FileFault::Empty);
    EXPECT_EQ(problemOf(" \n\n").kind, FileFault::Empty);
}

TEST(BadMachineFile, SomethingElse) {
    EXPECT_EQ(problemOf("[1, 2]").kind, FileFault::OtherFormat);
    EXPECT_EQ(problemOf("{}").kind, FileFault::OtherFormat);
    EXPECT_EQ(problemOf("{\"format\": 1, \"version\": 1}").kind, FileFault::OtherFormat);
    EXPECT_EQ(problemOf("{\n\"format\": \"recipe\", \"version\": 1}"),
              (FileProblem{.kind = FileFault::OtherFormat, .line = 2, .field = "format"}));
    EXPECT_EQ(problemOf("time,position\n1,2\n").kind, FileFault::NotJson);
    EXPECT_EQ(problemOf(std::string("\x7F"
                                    "ELF\x02\x01\x01\0\0",
                                    9))
                  .kind,
              FileFault::NotJson);
}

TEST(BadMachineFile, OfANewerProgram) {
    EXPECT_EQ(problemOf("{\n\"format\": \"nmc-panel-machine\",\n\"version\": 2, \"axes\": 5}"),
              (FileProblem{
                  .kind = FileFault::NewerVersion, .line = 3, .field = "version", .found = "2", .max = 1}));
    EXPECT_EQ(problemOf("{\"format\": \"nmc-panel-machine\"}").kind, FileFault::Missing);
    EXPECT_EQ(problemOf("{\"format\": \"nmc-panel-machine\", \"version\": 0}").kind, FileFault::OutOfRange);
}

TEST(BadMachineFile, NotJsonInLine3) {
    for (const std::string line :
         {"\"name\" \"x\"", "\"name\": x", "\"name\": 'x'", "\"name\": 01", "// no comments", "\"a\": 1,",
          "\"name\": \"a\tb\"", "\"name\": \"\\x\"", "} {"}) {
        const FileProblem problem = problemOf(fileWith(line));
        EXPECT_EQ(problem.kind, FileFault::NotJson) << line;
        EXPECT_GE(problem.line, 3) << line;
        EXPECT_LE(problem.line, 4) << line;
    }
}

TEST(BadMachineFile, NumbersThatAreNone) {
    EXPECT_EQ(problemOf(fileWith("\"rate_bd\": NaN")),
              (FileProblem{.kind = FileFault::NotANumber, .line = 3, .found = "NaN"}));
    EXPECT_EQ(problemOf(fileWith("\"rate_bd\": nan")).kind, FileFault::NotANumber);
    EXPECT_EQ(problemOf(fileWith("\"rate_bd\": -Infinity")).kind, FileFault::NotANumber);
    EXPECT_EQ(problemOf(fileWith("\"rate_bd\": 1e999")),
              (FileProblem{.kind = FileFault::NumberTooBig, .line = 3}));
    EXPECT_EQ(problemOf(fileWith("\"of_another_program\": -1e999")).kind, FileFault::NumberTooBig);
}

TEST(BadMachineFile, BytesThatAreNoLetters) {
    // A lone continuation byte, an overlong slash, a surrogate, a code point beyond U+10FFFF, Latin-1.
    for (const std::string bytes : {"\x80", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE4 "})
        EXPECT_EQ(problemOf(fileWith("\"name\": \"" + bytes + "\"")),
                  (FileProblem{.kind = FileFault::NotUtf8, .line = 3}));
    EXPECT_EQ(problemOf(fileWith("\"name\": \"a\\u001bb\"")),
              (FileProblem{.kind = FileFault::UnprintableText, .line = 3, .field = "name"}));
}

/// The points are in line 3; after them, each sequence and each of its rows begins on a line of its own.
TEST(BadMachineFile, PointsAndSequencesThatCannotBe) {
    const auto program = [](const std::string& rows) {
        return fileWith(
            "\"points\": [{\"name\": \"P\", \"axes\": []}],\n\"sequences\": [\n"
            "{\"name\": \"A\", \"rows\": [\n" +
            rows + "\n]},\n{\"name\": \"B\", \"rows\": [{\"do\": \"call\", \"sequence\": \"A\"}]}]");
    };
    const std::string wait = "{\"do\": \"wait\", \"seconds\": 1}";
    EXPECT_TRUE(parseMachine(program(wait)).has_value());
    const auto expect = [&](const std::string& row, FileFault kind, const std::string& field,
                            const std::string& found) {
        EXPECT_EQ(problemOf(program(wait + ",\n" + row)),
                  (FileProblem{.kind = kind, .line = 7, .field = field, .found = found}));
    };
    expect("{\"do\": \"call\", \"sequence\": \"B\"}", FileFault::CallsItself, "sequences", "A");
    expect("{\"do\": \"call\", \"sequence\": \"A\"}", FileFault::CallsItself, "sequences", "A");
    expect("{\"do\": \"call\", \"sequence\": \"X\"}", FileFault::NoSuchSequence, "sequences", "X");
    expect("{\"do\": \"move to\", \"point\": \"Q\", \"together\": true, \"waits\": true, \"percent\": 1}",
           FileFault::NoSuchPoint, "sequences", "Q");
    expect("{\"do\": \"repeat\", \"from_row\": 2, \"times\": 2}", FileFault::RepeatsBelow, "sequences", "");
    expect("{\"do\": \"dance\"}", FileFault::UnknownWord, "do", "dance");
    EXPECT_EQ(problemOf(program("{\"do\": \"home\", \"module\": 33}")).kind, FileFault::OutOfRange);
    EXPECT_EQ(problemOf(program("{\"do\": \"home\"}")),
              (FileProblem{.kind = FileFault::Missing, .line = 6, .field = "module"}));
    EXPECT_EQ(problemOf(program("{\"do\": \"wait\", \"seconds\": -1}")).kind, FileFault::OutOfRange);
}

TEST(BadMachineFile, NamesAndAxesThatAreThereTwice) {
    EXPECT_EQ(problemOf(fileWith("\"points\": [{\"name\": \"P\"},\n{\"name\": \"P\"}]")),
              (FileProblem{.kind = FileFault::NameTwice, .line = 4, .field = "points", .found = "P"}));
    EXPECT_EQ(problemOf(fileWith("\"sequences\": [{\"rows\": []}]")),
              (FileProblem{.kind = FileFault::NameMissing, .line = 3, .field = "sequences"}));
    const std::string axis = "{\"module\": 2, \"counts\": 0, \"from_home\": true}";
    EXPECT_EQ(problemOf(fileWith("\"points\": [{\"name\": \"P\", \"axes\": [" + axis + "," + axis + "]}]")),
              (FileProblem{.kind = FileFault::AxisTwice, .line = 3, .field = "points", .found = "2"}));
    EXPECT_EQ(problemOf(fileWith("\"home_order\": [1,\n2, 1]")),
              (FileProblem{.kind = FileFault::AxisTwice, .line = 4, .field = "home_order", .found = "1"}));
    EXPECT_EQ(problemOf(fileWith("\"points\": [{\"name\": \"P\", \"axes\": [\n{\"module\": 1, \"counts\": "
                                 "2147483648, \"from_home\": true}]}]"))
                  .line,
              4)
        << "beyond the chip's range";
}

TEST(BadMachineFile, KeysThatAreThereTwice) {
    EXPECT_EQ(problemOf(fileWith("\"name\": \"a\",\n\"name\": \"b\"")),
              (FileProblem{.kind = FileFault::DuplicateKey, .line = 4, .field = "name"}));
    EXPECT_EQ(problemOf(fileWith("\"x\": {\"y\": 1,\n \"y\": 1}")).kind, FileFault::DuplicateKey);
}

std::string nested(int lists) {
    const auto count = static_cast<std::size_t>(lists);
    return fileWith("\"x\": " + std::string(count, '[') + std::string(count, ']'));
}

TEST(BadMachineFile, TooDeepTooManyTooLarge) {
    EXPECT_TRUE(parseMachine(nested(31)).has_value()) << "32 levels with the file's own object";
    EXPECT_EQ(problemOf(nested(32)), (FileProblem{.kind = FileFault::TooDeep, .line = 3, .max = 32}));
    EXPECT_EQ(problemOf(nested(400'000)).kind, FileFault::TooDeep);

    std::string values = "\"x\": [0";
    for (int i = 0; i < 50'000; ++i)
        values += ",0";
    EXPECT_EQ(problemOf(fileWith(values + "]")).kind, FileFault::TooManyValues);

    const std::string most = fileWith("");
    EXPECT_EQ(problemOf(most + std::string(1'000'001 - most.size(), ' ')).kind, FileFault::TooLarge);
    const std::string good = writeMachine({});
    EXPECT_TRUE(parseMachine(good + std::string(1'000'000 - good.size(), ' ')).has_value());
}

TEST(BadMachineFile, TooManyAxesOrNames) {
    std::string axes = "\"axes\": [{}";
    for (int i = 1; i < 32; ++i)
        axes += ",{}";
    EXPECT_TRUE(parseMachine(fileWith(axes + "]")).has_value());
    EXPECT_EQ(problemOf(fileWith(axes + ",{}]")),
              (FileProblem{.kind = FileFault::TooMany, .line = 3, .field = "axes", .max = 32}));
    EXPECT_EQ(problemOf(axisWith("\"input_names\": [\"a\", \"b\", \"c\"]")),
              (FileProblem{.kind = FileFault::TooMany, .line = 4, .field = "input_names", .max = 2}));
}

struct BadValue {
    const char* line;
    FileProblem problem;
};

TEST(BadMachineFile, ValuesOfAnotherType) {
    const BadValue cases[] = {
        {"\"name\": 5", {.field = "name", .wanted = Wanted::Text}},
        {"\"expected\": 3", {.field = "expected", .wanted = Wanted::Object}},
        {"\"expected\": {\"type\": [], \"version\": 1}", {.field = "type", .wanted = Wanted::Text}},
        {"\"unit\": []", {.field = "unit", .wanted = Wanted::Object}},
        {"\"motion\": {\"velocity_counts_per_tick\": \"8\"}",
         {.field = "velocity_counts_per_tick", .wanted = Wanted::Number}},
        {"\"motion\": {\"step_counts\": null}", {.field = "step_counts", .wanted = Wanted::Number}},
        {"\"gains\": {\"Kp\": 1.5}", {.field = "Kp", .wanted = Wanted::WholeNumber}},
        {"\"gains\": {\"Kp\": true}", {.field = "Kp", .wanted = Wanted::WholeNumber}},
        {"\"io\": {\"limit1_is_input\": 1}", {.field = "limit1_is_input", .wanted = Wanted::YesOrNo}},
        {"\"output_names\": \"Pump\"", {.field = "output_names", .wanted = Wanted::List}},
        {"\"pins\": {\"pins\": 1}", {.field = "pins", .wanted = Wanted::List}},
        {"\"output_names\": [1]", {.field = "output_names", .wanted = Wanted::Text}},
    };
    for (const auto& [line, expected] : cases) {
        FileProblem problem = expected;
        problem.kind = FileFault::WrongType;
        problem.line = 4;
        EXPECT_EQ(problemOf(axisWith(line)), problem) << line;
    }
    EXPECT_EQ(problemOf(fileWith("\"axes\": [5]")).wanted, Wanted::Object);
    EXPECT_EQ(problemOf(fileWith("\"groups\": {}")).wanted, Wanted::List);
}

/// The complete gains of a file, with one of them replaced.
std::string gainsWith(const std::string& key, const std::string& value) {
    std::string text = "\"gains\": {";
    for (const std::string name : {"Kp", "Kd", "Ki", "IL", "OL", "CL", "EL_counts", "SR", "DB"})
        text += (name == "Kp" ? "\"" : ", \"") + name + "\": " + (name == key ? value : "1");
    return text + "}";
}
std::string parametersWith(const std::string& key, const std::string& value) {
    std::string text =
        "\"parameters\": {\"speed_mode\": \"1x\", \"ignore_limits\": false, "
        "\"ignore_estop\": false, \"motor_off_on_limit_or_estop\": false";
    for (const std::string name : {"minimum_profile_speed", "run_current", "hold_current", "thermal_limit"})
        text += ", \"" + name + "\": " + (name == key ? value : "1");
    return text + "}";
}
std::string homingWith(const std::string& key, const std::string& value) {
    std::string text = "\"homing\": {\"stop\": \"smoothly\"";
    for (const std::string name :
         {"on_limit1", "on_limit2", "on_index", "on_position_error", "on_current_limit", "on_home_switch",
          "then_index", "reverse", "go_to_home", "make_zero"})
        text += ", \"" + name + "\": true";
    for (const std::string name :
         {"velocity_counts_per_tick", "acceleration_counts_per_tick2", "travel_limit_counts", "time_limit_s"})
        text += ", \"" + name + "\": " + (name == key ? value : "1");
    return text + "}";
}

struct RangeCase {
    std::string (*with)(const std::string& key, const std::string& value);
    const char* key;
    double min;
    double max;
    const char* below;  ///< the nearest numbers outside the range
    const char* above;
    bool ofModule = true;
};

// The ranges of DS-V 5.2 Set Gain and DS-S 5.1 Set Parameters.
TEST(BadMachineFile, NumbersOutOfTheModulesRanges) {
    const RangeCase cases[] = {
        {gainsWith, "Kp", 0, 32'767, "-1", "32768"},
        {gainsWith, "Kd", 0, 32'767, "-1", "32768"},
        {gainsWith, "Ki", 0, 32'767, "-1", "32768"},
        {gainsWith, "IL", 0, 32'767, "-1", "32768"},
        {gainsWith, "OL", 0, 255, "-1", "256"},
        {gainsWith, "CL", 0, 255, "-1", "256"},
        {gainsWith, "EL_counts", 0, 16'383, "-1", "16384"},
        {gainsWith, "SR", 1, 255, "0", "256"},
        {gainsWith, "DB", 0, 255, "-1", "256"},
        {parametersWith, "minimum_profile_speed", 1, 250, "0", "251"},
        {parametersWith, "run_current", 0, 255, "-1", "256"},
        {parametersWith, "hold_current", 0, 255, "-1", "256"},
        {parametersWith, "thermal_limit", 0, 255, "-1", "256"},
        {homingWith, "velocity_counts_per_tick", 0, 0x7FFFFFFF / 65'536.0, "-0.5", "32768"},
        {homingWith, "acceleration_counts_per_tick2", 0, 0x7FFFFFFF / 65'536.0, "-0.5", "32768"},
        {homingWith, "travel_limit_counts", 0, 0x7FFFFFFF, "-1", "2147483648"},
        {homingWith, "time_limit_s", 0, 86'400, "-1", "86401", false},
    };
    for (const RangeCase& c : cases) {
        EXPECT_TRUE(parseMachine(axisWith(c.with("none", ""))).has_value());
        for (const char* value : {c.below, c.above})
            EXPECT_EQ(problemOf(axisWith(c.with(c.key, value))), (FileProblem{.kind = FileFault::OutOfRange,
                                                                              .line = 4,
                                                                              .field = c.key,
                                                                              .found = value,
                                                                              .min = c.min,
                                                                              .max = c.max,
                                                                              .ofModule = c.ofModule}))
                << c.key;
    }
}

TEST(BadMachineFile, OtherNumbersOutOfRange) {
    const auto field = [](const std::string& text) {
        const FileProblem problem = problemOf(text);
        EXPECT_EQ(problem.kind, FileFault::OutOfRange) << text;
        return problem.field;
    };
    const auto motion = [](const std::string& key, const std::string& value, const std::string& type) {
        return axisWith("\"expected\": {\"type\": \"" + type + "\", \"version\": 1}, \"motion\": {\"" + key +
                        "\": " + value + "}");
    };
    for (const std::string key :
         {"velocity_counts_per_tick", "acceleration_counts_per_tick2", "run_velocity_counts_per_tick",
          "hold_velocity_counts_per_tick", "hold_cap_counts_per_tick"}) {
        EXPECT_EQ(field(motion(key, "-1e-9", "PIC-SERVO")), key);
        EXPECT_EQ(field(motion(key, "32767.99999", "PIC-SERVO")), key);
    }
    EXPECT_EQ(field(motion("step_counts", "2147483648", "PIC-SERVO")), "step_counts");
    EXPECT_EQ(field(motion("velocity_steps_per_s", "50001", "PIC-STEP")), "velocity_steps_per_s");
    EXPECT_EQ(field(axisWith("\"unit\": {\"kind\": \"turns\", \"counts_per_unit\": 0}")), "counts_per_unit");
    EXPECT_EQ(field(axisWith("\"unit\": {\"kind\": \"turns\", \"counts_per_unit\": -1e-7}")),
              "counts_per_unit");
    EXPECT_EQ(field(axisWith("\"expected\": {\"type\": 256, \"version\": 1}")), "type");
    EXPECT_EQ(field(axisWith("\"expected\": {\"type\": 0, \"version\": 256}")), "version");
    EXPECT_EQ(field(axisWith("\"acceleration_time\": 256")), "acceleration_time");
    EXPECT_EQ(field(axisWith("\"analog\": {\"per_count\": 1e13, \"at_zero\": 0}")), "per_count");
    EXPECT_EQ(field(fileWith("\"rate_bd\": -1")), "rate_bd");
    EXPECT_EQ(field(fileWith("\"rate_bd\": 1e20")), "rate_bd");
    EXPECT_EQ(field(fileWith("\"groups\": [{\"address\": 127}]")), "address");
    EXPECT_EQ(field(fileWith("\"groups\": [{\"address\": 255}]")), "address");
    EXPECT_EQ(field(fileWith("\"groups\": [{\"address\": 129, \"modules\": [0]}]")), "modules");
    EXPECT_EQ(field(fileWith("\"groups\": [{\"address\": 129, \"modules\": [33]}]")), "modules");
    EXPECT_EQ(field(fileWith("\"groups\": [{\"address\": 129, \"leader\": 0}]")), "leader");
}

TEST(BadMachineFile, FieldsThatAreMissing) {
    const auto missing = [](const std::string& text) {
        const FileProblem problem = problemOf(text);
        EXPECT_EQ(problem.kind, FileFault::Missing) << text;
        return std::pair(problem.line, problem.field);
    };
    EXPECT_EQ(missing(axisWith("\"gains\": {\"Kp\": 1}")), std::pair(4, std::string("Kd")));
    EXPECT_EQ(missing(axisWith("\"expected\": {\"type\": 0}")), std::pair(4, std::string("version")));
    EXPECT_EQ(missing(axisWith("\"unit\": {\"kind\": \"degrees\"}")),
              std::pair(4, std::string("counts_per_unit")));
    EXPECT_EQ(missing(fileWith("\"groups\": [\n{\"name\": \"Table\"}]")),
              std::pair(4, std::string("address")));
}

TEST(BadMachineFile, WordsThatAreNotKnown) {
    EXPECT_EQ(problemOf(axisWith("\"unit\": {\"kind\": \"inches\"}")),
              (FileProblem{.kind = FileFault::UnknownWord, .line = 4, .field = "kind", .found = "inches"}));
    const std::string longWord(500, 'x');
    EXPECT_LT(problemOf(axisWith("\"unit\": {\"kind\": \"" + longWord + "\"}")).found.size(), 50U);
    EXPECT_EQ(problemOf(axisWith("\"expected\": {\"type\": \"SERVO\", \"version\": 1}")).kind,
              FileFault::UnknownWord);
}

TEST(BadMachineFile, UnitsOfTheOtherChip) {
    EXPECT_EQ(problemOf(axisWith("\"motion\": {\"velocity_steps_per_s\": 8}")),
              (FileProblem{.kind = FileFault::OtherChip, .line = 4, .field = "velocity_steps_per_s"}));
    EXPECT_EQ(problemOf(axisWith("\"motion\": {\"step_counts\": 8},\n"
                                 "\"expected\": {\"type\": \"PIC-STEP\", \"version\": 1}")),
              (FileProblem{.kind = FileFault::OtherChip, .line = 4, .field = "step_counts"}));
}

TEST(BadMachineFile, LimitsThatLeaveNoPlaceToBe) {
    EXPECT_EQ(problemOf(axisWith("\"travel\": {\"lowest_counts\": 8, \"highest_counts\": 8}")),
              (FileProblem{.kind = FileFault::LimitsCrossed, .line = 4, .field = "travel"}));
    EXPECT_EQ(problemOf(axisWith("\"travel\": {\"lowest_steps\": 8}")).kind, FileFault::OtherChip);
    EXPECT_EQ(problemOf(axisWith("\"travel\": {\"lowest_counts\": 2147483648}")).kind, FileFault::OutOfRange);
}

TEST(BadMachineFile, WorkOffsetsThatCannotBeToldApart) {
    const std::string a = R"({"name": "A", "from_home": 1})";
    EXPECT_TRUE(parseMachine(axisWith("\"work_offsets\": [" + a + "]")).has_value());
    EXPECT_EQ(problemOf(axisWith("\"work_offsets\": [" + a + ", " + a + "]")),
              (FileProblem{.kind = FileFault::NameTwice, .line = 4, .field = "work_offsets", .found = "A"}));
    EXPECT_EQ(problemOf(axisWith(R"("work_offsets": [{"name": "", "from_home": 1}])")),
              (FileProblem{.kind = FileFault::NameMissing, .line = 4, .field = "work_offsets"}));
    EXPECT_EQ(problemOf(axisWith(R"("work_offsets": [{"name": "A"}])")).kind, FileFault::Missing);
    EXPECT_EQ(problemOf(axisWith(R"("work_offsets": [{"name": "A", "from_home": 2147483648}])")).kind,
              FileFault::OutOfRange);
}

TEST(BadMachineFile, GroupsThatContradictEachOther) {
    const auto groups = [](const std::string& a, const std::string& b) {
        return problemOf(fileWith("\"groups\": [{" + a + "},\n{" + b + "}]"));
    };
    EXPECT_EQ(groups("\"address\": 129, \"modules\": [1, 2]", "\"address\": 130, \"modules\": [2]"),
              (FileProblem{.kind = FileFault::ModuleTwice, .line = 4, .field = "modules", .found = "2"}));
    EXPECT_EQ(groups("\"address\": 129, \"modules\": [1, 1]", "\"address\": 130").kind,
              FileFault::ModuleTwice);
    EXPECT_EQ(groups("\"address\": 129", "\"address\": 129"),
              (FileProblem{.kind = FileFault::AddressTwice, .line = 4, .field = "address", .found = "129"}));
    EXPECT_EQ(groups("\"address\": 129", "\"address\": 130, \"modules\": [1], \"leader\": 2"),
              (FileProblem{.kind = FileFault::LeaderNotInGroup, .line = 4, .field = "leader"}));
}

}  // namespace
}  // namespace nmc
