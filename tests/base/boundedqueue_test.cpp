// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/boundedqueue.h"

#include <gmock/gmock.h>

#include <thread>

namespace nmc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(BoundedQueue, GivesValuesInTheirOrderOnce) {
    BoundedQueue<int> queue(8);
    queue.push(1);
    queue.push(2);
    EXPECT_THAT(queue.takeAll(), ElementsAre(1, 2));
    EXPECT_THAT(queue.takeAll(), IsEmpty());
}

TEST(BoundedQueue, AsksForAWakeUpOnlyWhenItWasEmpty) {
    BoundedQueue<int> queue(8);
    EXPECT_TRUE(queue.push(1));
    EXPECT_FALSE(queue.push(2));
    (void)queue.takeAll();
    EXPECT_TRUE(queue.push(3));
}

TEST(BoundedQueue, DropsTheOldestWhenFullAndCountsIt) {
    BoundedQueue<int> queue(3);
    for (int i = 1; i <= 5; ++i)
        queue.push(i);
    EXPECT_THAT(queue.takeAll(), ElementsAre(3, 4, 5));
    EXPECT_EQ(queue.dropped(), 2U);
}

TEST(BoundedQueue, LosesNothingBetweenTwoThreads) {
    constexpr int kCount = 20'000;
    BoundedQueue<int> queue(kCount);
    std::thread writer([&queue] {
        for (int i = 0; i < kCount; ++i)
            queue.push(i);
    });
    int expected = 0;
    while (expected < kCount)
        for (const int value : queue.takeAll())
            ASSERT_EQ(value, expected++);
    writer.join();
    EXPECT_EQ(queue.dropped(), 0U);
}

}  // namespace
}  // namespace nmc
