// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a recording: the same is read however they are cut; what was read is the same after it was
// written again; anything else is refused with the number of an existing line.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "model/recording/recordingreader.h"

namespace {

void require(bool condition) {
    if (!condition)
        std::abort();
}

struct Read {
    nmc::RecordingHeader header;
    std::string rows{};  ///< as they are written again
    std::optional<nmc::RecordingProblem> problem{};
};

Read readInPieces(std::string_view text, std::size_t piece) {
    Read read;
    nmc::RecordingReader reader(
        {[&](nmc::ModuleIndex module, const nmc::ScopeSample& sample) {
             appendRow(read.rows, module, sample, {});
         },
         [&](const nmc::GainsChange& change) { appendGains(read.rows, change, {}); }});
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size())))
        if (!reader.feed(text.substr(0, piece)))
            break;
    read.problem = reader.finish();
    read.header = reader.header();
    return read;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    const Read read = readInPieces(text, text.size());
    const Read again = readInPieces(text, 1 + size / 7);
    require(again.rows == read.rows && again.problem == read.problem && again.header == read.header);
    if (read.problem)
        require(read.problem->line >= 1 && read.problem->line <= 1 + static_cast<std::uint64_t>(std::count(
                                                                         text.begin(), text.end(), '\n')));
    const std::string head = recordingHead(read.header);
    const Read written = readInPieces(head + read.rows, 4'096);
    require(!written.problem && written.rows == read.rows && recordingHead(written.header) == head);
    return 0;
}
