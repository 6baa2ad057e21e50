// SPDX-License-Identifier: GPL-3.0-or-later
// Any lines from another program: each is a request or a problem, and what it asks of a module passes the
// checks that the user's requests pass.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "model/api/apimethods.h"

namespace {

/// A PIC-SERVO that holds at 0 with a travel limit, a PIC-STEP and a PIC-I/O of which little is known.
struct Chain {
    nmc::LinkState link;
    nmc::Machine machine;

    Chain() {
        const nmc::ModuleIdentity identities[] = {
            {nmc::ModuleType::Servo, 4}, {nmc::ModuleType::Stepper, 1}, {nmc::ModuleType::Io, 1}};
        link.phase = nmc::LinkPhase::Connected;
        for (const nmc::ModuleIdentity& identity : identities) {
            const auto number = static_cast<std::uint8_t>(link.modules.size());
            nmc::ModuleState& module = link.modules.emplace_back();
            module.info = {nmc::ModuleIndex(number), nmc::BusAddress(static_cast<std::uint8_t>(number + 1)),
                           identity};
        }
        link.modules[0].servoRate = 1;
        machine.axes.resize(3);
        machine.axes[0].name = "X";
        machine.axes[0].unit = {nmc::UnitKind::Millimetres, -100.0};
    }
};

void look(const Chain& chain, const nmc::api::Request& request) {
    if (!request.parameters.contains("axis") || request.method->make == nullptr)
        return;
    const auto call = nmc::api::callOf(*request.method, request.parameters, chain.link, chain.machine);
    if (!call)
        return;
    if (call->module.value() >= chain.link.modules.size())
        std::abort();
    if (const auto* intent = std::get_if<nmc::Intent>(&call->what))
        (void)nmc::plan(*intent, chain.link.modules[call->module.value()]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Chain chain;
    std::string_view lines(reinterpret_cast<const char*>(data), size);
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(lines.size(), line.size() + 1));
        const auto request = nmc::api::readRequest(line);
        if (!request)
            continue;
        // What is shown to the user is as flat as the table of parameters.
        for (const auto& parameter : request->parameters)
            if (parameter.is_structured())
                std::abort();
        look(chain, *request);
    }
    return 0;
}
