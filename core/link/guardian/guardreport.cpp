// SPDX-License-Identifier: MIT
#include "link/guardian/guardreport.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "base/numbertext.h"
#include "link/guardian/descriptor.h"
#include "protocol/frame.h"

namespace nmc {

namespace {

constexpr std::string_view kBegin = "nmcguard 1 stopped";
constexpr std::string_view kNameBegins = "guardian-";
constexpr std::string_view kNameEnds = ".report";
constexpr unsigned kMostModules = 127;

std::vector<std::uint8_t> addressesIn(ByteSpan burst) {
    std::vector<std::uint8_t> addresses;
    for (std::size_t i = 0; i + 2 < burst.size();) {
        if (burst[i] != kHeader) {
            ++i;  // a null between packets
            continue;
        }
        const std::uint8_t address = burst[i + 1];
        // A module may be sent several packets: its gains before its stop, or two of a PIC-I/O.
        if (address >= 1 && address <= kMostModules &&
            std::ranges::find(addresses, address) == addresses.end())
            addresses.push_back(address);
        i += 4U + (burst[i + 2] >> 4U);
    }
    return addresses;
}

/// Returns nothing when the name is not that of a report.
std::optional<long> processIn(std::string_view name) {
    if (!name.starts_with(kNameBegins) || !name.ends_with(kNameEnds))
        return std::nullopt;
    name.remove_prefix(kNameBegins.size());
    name.remove_suffix(std::min(name.size(), kNameEnds.size()));
    return numberIn<long>(name);
}

std::optional<GuardReport> read(const std::string& file, long process) {
    const Descriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    std::array<char, 1'024> text{};
    const auto size = fd.valid() ? ::read(fd.get(), text.data(), text.size()) : -1;
    if (size < 0 || !std::string_view(text.data(), static_cast<std::size_t>(size)).starts_with(kBegin))
        return std::nullopt;
    std::istringstream words(
        std::string(text.data() + kBegin.size(), static_cast<std::size_t>(size) - kBegin.size()));
    GuardReport report{process, {}};
    for (unsigned number = 0; words >> number && number >= 1 && number <= kMostModules;)
        report.modules.push_back(static_cast<std::uint8_t>(number));
    return report;
}

}  // namespace

bool writeGuardReport(const std::string& file, const StopBurst& burst) {
    std::string text(kBegin);
    for (const std::uint8_t address : addressesIn(burst.span()))
        text += ' ' + std::to_string(address);
    text += '\n';
    const std::string unfinished = file + ".new";
    Descriptor fd(::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600));
    // The file is not synchronized with the disk: it only needs to outlive a process, and the panel may be
    // waiting for us.
    return fd.valid() && ::write(fd.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
           ::rename(unfinished.c_str(), file.c_str()) == 0;
}

std::vector<GuardReport> takeGuardReports(const std::string& folder) {
    std::vector<GuardReport> reports;
    std::error_code none;
    for (std::filesystem::directory_iterator entry(folder, none), end; entry != end; entry.increment(none)) {
        const std::string file = entry->path().string();
        const auto process = processIn(entry->path().filename().string());
        const auto report = process ? read(file, *process) : std::nullopt;
        // When two panels start at the same time, the one that removes the file reports it.
        if (report && ::unlink(file.c_str()) == 0)
            reports.push_back(*report);
    }
    return reports;
}

std::string guardReportFile(const std::string& folder) {
    return folder + '/' + std::string(kNameBegins) + std::to_string(::getpid()) + std::string(kNameEnds);
}

}  // namespace nmc
