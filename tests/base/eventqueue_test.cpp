// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/eventqueue.h"

#include <gmock/gmock.h>

#include <thread>

namespace nmc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(EventQueue, KeepsNewsAndSamplesInOneOrder) {
    EventQueue<int> queue(8);
    queue.pushSample(1);
    queue.pushNews(2);
    queue.pushNews(3);
    queue.pushSample(4);
    EXPECT_THAT(queue.takeAll(), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(queue.takeAll(), IsEmpty());
}

TEST(EventQueue, AsksForAWakeUpOnlyWhenItWasEmpty) {
    EventQueue<int> queue(8);
    EXPECT_TRUE(queue.pushSample(1));
    EXPECT_FALSE(queue.pushNews(2));
    (void)queue.takeAll();
    EXPECT_TRUE(queue.pushNews(3));
    EXPECT_FALSE(queue.pushSample(4));
}

TEST(EventQueue, DropsTheOldestSamplesButNoNews) {
    EventQueue<int> queue(2);
    queue.pushNews(-1);
    for (int i = 1; i <= 3; ++i)
        queue.pushSample(i);
    queue.pushNews(-2);
    queue.pushSample(4);
    for (int i = 3; i <= 5; ++i)
        queue.pushNews(-i);
    EXPECT_THAT(queue.takeAll(), ElementsAre(-1, 3, -2, 4, -3, -4, -5));
    EXPECT_EQ(queue.dropped(), 2U);
}

TEST(EventQueue, LosesNoNewsBetweenTwoThreads) {
    constexpr int kCount = 20'000;
    EventQueue<int> queue(16);
    std::thread writer([&queue] {
        for (int i = 0; i < kCount; ++i) {
            queue.pushSample(-1);
            queue.pushNews(i);
        }
    });
    int expected = 0;
    while (expected < kCount)
        for (const int value : queue.takeAll())
            if (value >= 0) {
                ASSERT_EQ(value, expected++);
            }
    writer.join();
}

}  // namespace
}  // namespace nmc
