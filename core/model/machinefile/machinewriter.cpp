// SPDX-License-Identifier: MIT
#include "model/machinefile/fieldwriter.h"
#include "model/machinefile/machinefile.h"

namespace nmc {

std::string writeMachine(const Machine& machine, const UnknownKeys& unknown) {
    using Json = layout::FieldWriter::Json;
    Json file = Json::parse(unknown.text, nullptr, false);
    if (!file.is_object())
        file = Json::object();
    file["format"] = layout::kFormat;
    file["version"] = layout::kVersion;
    layout::FieldWriter writer(file);
    layout::fields(writer, machine);
    return layout::fileText(file);
}

}  // namespace nmc
