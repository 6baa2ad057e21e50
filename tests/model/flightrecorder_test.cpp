// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/flightrecorder.h"

#include <gtest/gtest.h>

#include "servofixture.h"

namespace nmc {
namespace {

using testing_support::atSeconds;

/// Two modules, ten samples a second each, from 0 to `end`.
History until(double end) {
    History history(2);
    for (int i = 0; i <= end * 10; ++i)
        for (std::uint8_t module = 0; module < 2; ++module) {
            ScopeSample sample;
            sample.time = atSeconds(i / 10.0);
            sample.position = i;
            history.append(ModuleIndex(module), sample);
        }
    return history;
}

TEST(FlightRecorder, KeepsFiveSecondsBeforeAndTwoAfterOfAllModules) {
    FlightRecorder recorder;
    const unsigned trip = recorder.note(ModuleIndex(1), atSeconds(60), until(60));
    recorder.keep(until(62.5), atSeconds(62.5));
    const auto* incident = recorder.find(trip, History());
    ASSERT_NE(incident, nullptr);
    EXPECT_TRUE(incident->whole);
    EXPECT_EQ(incident->module, ModuleIndex(1));
    EXPECT_EQ(incident->history.begin(), atSeconds(55));
    EXPECT_EQ(incident->history.end(), atSeconds(62));
    EXPECT_EQ(incident->history.module(ModuleIndex(0))->count(), 71U);
    EXPECT_EQ(incident->history.module(ModuleIndex(1))->count(), 71U);
}

TEST(FlightRecorder, ShowsWhatThereIsBeforeItIsWhole) {
    FlightRecorder recorder;
    const unsigned trip = recorder.note({}, atSeconds(60), until(60));
    recorder.keep(until(60.5), atSeconds(60.5));
    const auto* incident = recorder.find(trip, until(61));
    ASSERT_NE(incident, nullptr);
    EXPECT_FALSE(incident->whole);
    EXPECT_EQ(incident->history.end(), atSeconds(61));
}

TEST(FlightRecorder, OutlivesTheHistory) {
    FlightRecorder recorder;
    const unsigned stop = recorder.note({}, atSeconds(10), until(10));
    recorder.keepAll(until(10.3));
    EXPECT_EQ(recorder.find(stop, History())->history.end(), atSeconds(10.3));
}

TEST(FlightRecorder, TakesNothingFromTheHistoryOfAnotherChain) {
    FlightRecorder recorder;
    const unsigned trip = recorder.note(ModuleIndex(1), atSeconds(60), until(60));
    History other(1);
    ScopeSample sample;
    sample.time = atSeconds(61);
    other.append(ModuleIndex(0), sample);
    EXPECT_EQ(recorder.find(trip, other)->history.end(), atSeconds(60));
    recorder.keep(other, atSeconds(62.5));
    const auto* incident = recorder.find(trip, other);
    EXPECT_EQ(incident->history.modules(), 2U);
    EXPECT_EQ(incident->history.begin(), atSeconds(55));
    EXPECT_EQ(incident->history.end(), atSeconds(60));
}

/// The chain fell silent at 60 s, ten seconds before: the record reaches back to 65 s.
TEST(FlightRecorder, IsEmptyWhereThereIsNoSampleAroundTheIncident) {
    FlightRecorder recorder;
    const unsigned stop = recorder.note({}, atSeconds(70), until(60));
    EXPECT_TRUE(recorder.find(stop, until(60))->history.empty());
    History other(1);
    ScopeSample sample;
    sample.time = atSeconds(71);
    other.append(ModuleIndex(0), sample);
    recorder.keep(other, atSeconds(72.5));
    EXPECT_TRUE(recorder.find(stop, other)->history.empty()) << "the sample is of another chain";
}

TEST(FlightRecorder, KeepsEachIncidentUnderItsNumber) {
    FlightRecorder recorder;
    const unsigned first = recorder.note({}, atSeconds(10), until(10));
    const unsigned second = recorder.note({}, atSeconds(30), until(30));
    recorder.keepAll(until(40));
    EXPECT_EQ(recorder.find(first, History())->history.begin(), atSeconds(5));
    EXPECT_EQ(recorder.find(second, History())->history.begin(), atSeconds(25));
}

TEST(FlightRecorder, TheOldestIncidentsMakeRoom) {
    FlightRecorder recorder;
    const unsigned first = recorder.note({}, atSeconds(0), History());
    const unsigned second = recorder.note({}, atSeconds(1), History());
    for (std::size_t i = 2; i <= FlightRecorder::kKept; ++i)
        (void)recorder.note({}, atSeconds(static_cast<double>(i)), History());
    EXPECT_EQ(recorder.find(first, History()), nullptr);
    EXPECT_NE(recorder.find(second, History()), nullptr);
}

}  // namespace
}  // namespace nmc
