// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/api/apimethods.h"
#include "model/recording/recording.h"

namespace nmc::api {

/// A recording (model/recording) of the samples that a program receives from the interface (docs/api.md).
/// Times are seconds since the first sample. Pure.
class ApiRecording {
public:
    /// `state`: the result of the method of that name. `program`, `startedAt`: as in RecordingHeader.
    ApiRecording(const Json& state, std::string program, std::string startedAt);

    /// What the file begins with.
    [[nodiscard]] std::string head() const { return recordingHead(m_header); }
    /// Whether the parameters of a "samples" notification are of the chain that `state` was of: the times of
    /// another one start again from 0.
    [[nodiscard]] bool isOfThisChain(const Json& samples) const;
    /// The rows for them.
    [[nodiscard]] std::string rowsOf(const Json& samples);

private:
    RecordingHeader m_header;
    std::optional<double> m_begin{};         ///< s, time of the first sample
    std::map<std::size_t, double> m_last{};  ///< s, of each module
    std::set<std::size_t> m_gaps{};          ///< modules of which samples are missing before the next one
};

}  // namespace nmc::api
