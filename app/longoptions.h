// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <getopt.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

namespace nmc {

/// An option of a command line, --NAME or --NAME=VALUE, and what it does.
struct LongOption {
    const char* name;
    int argument;  ///< as for getopt_long()
    /// `value` is null if there is none.
    std::function<void(const char* value)> take;
};

/// Takes the options in their order; `order` is as for getopt_long(). The other words are from optind on.
/// Returns false after one that does not exist or lacks its value, which has been reported. Two more end the
/// program: --help, which prints what `help` prints, and --version.
[[nodiscard]] inline bool takeLongOptions(int argc, char** argv, const char* order,
                                          std::vector<LongOption> options, void (*help)(),
                                          const char* version) {
    options.push_back({"help", no_argument, [help](const char*) {
                           help();
                           std::exit(EXIT_SUCCESS);
                       }});
    options.push_back({"version", no_argument, [version](const char*) {
                           std::puts(version);
                           std::exit(EXIT_SUCCESS);
                       }});
    std::vector<option> table;
    for (const LongOption& one : options)
        table.push_back({one.name, one.argument, nullptr, 0});
    table.push_back({nullptr, 0, nullptr, 0});
    int which = 0;
    for (int at = 0; (which = ::getopt_long(argc, argv, order, table.data(), &at)) == 0;)
        options[static_cast<std::size_t>(at)].take(optarg);
    return which == -1;
}

}  // namespace nmc
