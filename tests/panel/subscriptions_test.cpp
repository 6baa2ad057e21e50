// SPDX-License-Identifier: GPL-3.0-or-later
// What programs are sent that have subscribed (docs/api.md, "Notifications").
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "tests/panel/otherprograms.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using Json = testing_support::OtherProgram::Json;
using testing_support::OtherProgram;
using testing_support::OtherPrograms;
using testing_support::RuntimeFolder;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class SubscribedPrograms : public OtherPrograms {};

TEST_F(SubscribedPrograms, AreToldWhatTheySubscribeTo) {
    OtherProgram client(panel, path());
    client.hello();
    EXPECT_TRUE(
        client.call("subscribe", {{"state", true}, {"samples", true}, {"events", true}}).contains("result"));
    EXPECT_EQ(client.notification("state")["params"]["modules"].size(), 2U);
    const Json samples = client.notification("samples")["params"];
    EXPECT_EQ(samples["missed"], 0);
    EXPECT_EQ(samples["modules"][0]["axis"], 1);
    const Json& row = samples["modules"][0]["rows"][0];
    ASSERT_EQ(row.size(), 9U) << "time, position, error, velocity, status, aux, analog, gap, counted";
    EXPECT_TRUE(row[6].is_number_integer() && row[7].is_boolean() && row[8].is_null()) << row.dump();
    OtherProgram other(panel, path());
    other.hello("other.py");
    EXPECT_TRUE(client.notification("event")["params"]["text"].get<std::string>().find("other.py") !=
                std::string::npos);
}

/// The modules are shown as they were, and nobody asks them how they are.
TEST_F(SubscribedPrograms, AreToldThatNothingAnswersWhileTheNetworkIsRestarted) {
    OtherProgram client(panel, path());
    client.hello();
    EXPECT_EQ(client.call("state", {{"axis", 1}})["result"]["answers"], true);
    const LinkState& link = panel.composition().store().link();
    emit panel.window().restartNetworkRequested();
    ASSERT_TRUE(panel.waitFor([&] { return link.phase == LinkPhase::Connecting; }));
    const int ofOne = client.request("state", {{"axis", 1}});
    const int ofAll = client.request("state");
    const Json one = client.answer(ofOne)["result"];
    const Json all = client.answer(ofAll)["result"];
    ASSERT_EQ(all["phase"], "connecting");
    EXPECT_EQ(one["answers"], false);
    EXPECT_EQ(all["modules"][0], one);
}

TEST_F(SubscribedPrograms, AreSentNoSamplesFromBeforeTheySubscribed) {
    auto* letIn = panel.window().findChild<QAction*>(u"letProgramsInAction"_s);
    letIn->trigger();
    ASSERT_TRUE(panel.answersFor(2));
    letIn->trigger();
    const TimePoint zero = *panel.composition().store().history().zero();
    const double now = toSeconds(panel.module().latestTime - zero);
    OtherProgram client(panel, path());
    client.request("hello", {{"protocol", "1.1"}, {"program", "scan.py"}});
    client.request("subscribe", {{"samples", true}});
    const Json first = client.notification("samples")["params"]["modules"][0]["rows"][0];
    EXPECT_GE(first[0].get<double>(), now);
}

/// They get their share one after another, some of them only when the next samples are nearly due.
TEST_F(SubscribedPrograms, AreAllSentEverySampleHoweverManyTheyAre) {
    std::vector<std::unique_ptr<OtherProgram>> all;
    for (int i = 0; i < 30; ++i) {
        all.push_back(std::make_unique<OtherProgram>(panel, path()));
        all.back()->hello();
        EXPECT_TRUE(all.back()->call("subscribe", {{"samples", true}}).contains("result"));
    }
    const double begin = toSeconds(panel.module().latestTime - *panel.composition().store().history().zero());
    std::vector<std::vector<double>> times(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        while (times[i].empty() || times[i].back() < begin + 1) {
            const Json samples = all[i]->notification("samples")["params"];
            EXPECT_EQ(samples["missed"], 0);
            for (const Json& row : samples["modules"][0]["rows"])
                if (const auto time = row[0].get<double>(); time > begin && time < begin + 1.5)
                    times[i].push_back(time);
            ASSERT_FALSE(testing::Test::HasFailure());
        }
    std::size_t shortest = times.front().size();
    for (const std::vector<double>& each : times)
        shortest = std::min(shortest, each.size());
    EXPECT_GT(shortest, 50U);
    for (std::vector<double>& each : times)
        each.resize(shortest);
    EXPECT_EQ(std::ranges::count(times, times.front()), std::ssize(times));
    EXPECT_EQ(std::ranges::adjacent_find(times.front(), std::ranges::greater_equal{}), times.front().end())
        << "none twice, and in their order";
}

class SubscribedProgramsAtAPicIo : public OtherPrograms {
protected:
    SubscribedProgramsAtAPicIo() : OtherPrograms(u"io"_s) {}
};

TEST_F(SubscribedProgramsAtAPicIo, AreSentItsCounterAndItsInputs) {
    for (const auto& line : {u"set 1 analog 1 51"_s, u"set 1 analog 2 100"_s, u"set 1 analog 3 200"_s})
        ASSERT_TRUE(sim.control(line).contains(u"ok"_s)) << line.toStdString();
    OtherProgram client(panel, path());
    client.hello();
    EXPECT_TRUE(client.call("subscribe", {{"samples", true}}).contains("result"));
    Json row;
    do {
        row = client.notification("samples")["params"]["modules"][0]["rows"].back();
        ASSERT_EQ(row.size(), 9U);
    } while (row[6] != 51 || row[2] != 100 || row[3] != 200);
    EXPECT_EQ(row[1], 0) << "it has not counted anything";
    EXPECT_TRUE(row[8].is_boolean()) << row.dump();
}

TEST(SubscribedProgramsAtAPort, AreSentTheFirstSampleOfAnotherChainThere) {
    RuntimeFolder runtime;
    VirtualChain sim(u"servo,servo"_s), other(u"servo"_s);
    VirtualPanel panel;
    const QString port = sim.terminal();
    panel.composition().show({.port = port, .baud = 115'200});
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    panel.window().findChild<QAction*>(u"letProgramsInAction"_s)->trigger();
    OtherProgram client(panel, ApiServer::pathFor(port));
    client.hello();
    EXPECT_TRUE(client.call("subscribe", {{"samples", true}}).contains("result"));
    ASSERT_TRUE(panel.answersFor(1));
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return !sim.open(); }));
    sim.rename(u"elsewhere"_s);
    other.rename(port);
    client.arrived().clear();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(port));
    double first = 0;
    do {
        first = client.notification("samples")["params"]["modules"][0]["rows"][0][0].get<double>();
    } while (first > 0.9);  // of the chain of before
    EXPECT_EQ(first, 0.0);
}

/// Every sample is either in a row that it gets, or counted as missed.
TEST_F(SubscribedPrograms, ThatAreTooSlowAreToldHowManySamplesTheyMissed) {
    OtherProgram client(panel, path());
    client.hello();
    EXPECT_TRUE(client.call("subscribe", {{"samples", true}}).contains("result"));
    std::array<std::optional<double>, 2> first{};
    std::array<std::optional<double>, 2> last{};  // after all that were missed
    std::uint64_t accounted = 0;
    const auto take = [&] {
        const Json message = client.notification("samples")["params"];
        const auto missed = message["missed"].get<std::uint64_t>();
        for (const Json& module : message["modules"]) {
            const std::size_t i = module["axis"].get<std::size_t>() - 1;
            const Json& rows = module["rows"];
            accounted += rows.size();
            last[i] = rows.back()[0].get<double>();
            if (!first[i])
                first[i] = rows.front()[0].get<double>();
        }
        if (missed > 0)
            last = {};
        accounted += missed;
        return missed;
    };
    EXPECT_EQ(take(), 0U);
    client.setReading(false);
    ASSERT_TRUE(panel.answersFor(15.0));
    client.setReading(true);
    while (take() == 0)
        ASSERT_FALSE(testing::Test::HasFailure());
    while (!last[0] || !last[1]) {
        take();
        ASSERT_FALSE(testing::Test::HasFailure());
    }

    const History& history = panel.composition().store().history();
    const auto timeOf = [&](double seconds) { return *history.zero() + fromSeconds(seconds); };
    constexpr Duration rounding = std::chrono::microseconds(1);
    std::uint64_t samples = 0;
    for (std::uint8_t i = 0; i < 2; ++i)
        samples += history.module(ModuleIndex(i))
                       ->samples(timeOf(*first[i]) - rounding, timeOf(*last[i]) + rounding)
                       .size();
    EXPECT_EQ(accounted, samples);
}

TEST_F(SubscribedPrograms, ThatWantSamplesAgainHaveMissedNoneOfThem) {
    OtherProgram client(panel, path());
    client.hello();
    EXPECT_TRUE(client.call("subscribe", {{"samples", true}}).contains("result"));
    client.setReading(false);
    ASSERT_TRUE(panel.answersFor(15.0));  // of which it misses some
    const int ended = client.request("subscribe");
    ASSERT_TRUE(panel.answersFor(0.1));
    client.setReading(true);
    EXPECT_TRUE(client.answer(ended).contains("result"));
    client.arrived().clear();
    EXPECT_TRUE(client.call("subscribe", {{"samples", true}}).contains("result"));
    EXPECT_EQ(client.notification("samples")["params"]["missed"], 0);
}

}  // namespace
}  // namespace nmc
