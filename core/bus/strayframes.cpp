// SPDX-License-Identifier: MIT
#include "bus/strayframes.h"

#include <algorithm>

namespace nmc::bus {

namespace {

/// Enough for a decision; noise may produce thousands.
constexpr std::size_t kRemembered = 64;

template <typename Queue>
void push(Queue& queue, typename Queue::value_type value) {
    if (queue.size() == kRemembered)
        queue.pop_front();
    queue.push_back(value);
}

}  // namespace

void StrayFrames::onMissed(TimePoint now) {
    push(m_missed, now);
}

void StrayFrames::hear(ByteSpan bytes, TimePoint now, Duration byteTime) {
    const auto count = static_cast<Duration::rep>(bytes.size());
    if (now - byteTime * count > m_over)
        endBurst();
    m_bytes.appendWhatFits(bytes);
    m_last = now;
    m_over = now + byteTime * kSurplusCharacters;
}

bool StrayFrames::takeForeign(TimePoint now) {
    if (now > m_over)
        endBurst();
    while (!m_bursts.empty() && now - m_bursts.front().time > kWithin)
        m_bursts.pop_front();
    const auto frames =
        static_cast<std::size_t>(std::ranges::count_if(m_bursts, [](const Burst& run) { return run.frame; }));
    if (frames == 0)
        m_reported = false;
    if (m_reported || frames < kEnough || m_bursts.size() > frames * kRunsPerFrame)
        return false;
    m_reported = true;
    return true;
}

void StrayFrames::endBurst() {
    if (m_bytes.empty())
        return;
    const bool frame = isFrame();
    if (!frame || !paidFor())
        push(m_bursts, {m_last, frame});
    m_bytes.clear();
}

bool StrayFrames::isFrame() const {
    const ByteSpan bytes(m_bytes);
    if (bytes.size() < kShortest || bytes.size() > kMaxReply || uniform(bytes))
        return false;
    const ByteSpan command(m_command);
    const bool sent = bytes.size() <= command.size() &&
                      std::equal(bytes.begin(), bytes.end(), command.last(bytes.size()).begin());
    return !sent && sum8(bytes.first(bytes.size() - 1)) == bytes.back();
}

/// Attributes the frame to the oldest missing answer.
bool StrayFrames::paidFor() {
    while (!m_missed.empty() && m_last - m_missed.front() > kLatest)
        m_missed.pop_front();
    if (m_missed.empty())
        return false;
    m_missed.pop_front();
    return true;
}

}  // namespace nmc::bus
