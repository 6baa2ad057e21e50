// SPDX-License-Identifier: MIT
#include "model/response/frequencyfile.h"

#include <cmath>
#include <vector>

#include "base/numbertext.h"
#include "model/frequency/frequencyresponse.h"

namespace nmc {

std::string frequencyCsv(const RecordingHeader& origin, std::string_view module,
                         std::span<const FrequencyPoint> points, const GainsChange& gains, double speed) {
    std::vector<std::complex<double>> closed;
    std::vector<std::complex<double>> open;
    for (const FrequencyPoint& point : points) {
        closed.push_back(point.closed);
        open.push_back(point.open());
    }
    const std::vector<double> closedPhases = phases(closed);
    const std::vector<double> openPhases = phases(open);
    std::string out = "# NMC Panel frequency response 1\n";
    appendOrigin(out, origin);
    out.append("# module: ").append(module) += '\n';
    appendGains(out, gains, gains.time);
    if (speed != 0.0) {
        out += "# speed while measuring: ";
        appendNumber(out, std::round(speed));
        out += " counts/s\n";
    }
    out += "frequency_hz,closed_db,closed_deg,closed_doubt,open_db,open_deg\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (const double value :
             {points[i].hertz, decibels(closed[i]), closedPhases[i], points[i].doubt, decibels(open[i])}) {
            appendNumber(out, value);
            out += ',';
        }
        appendNumber(out, openPhases[i]);
        out += '\n';
    }
    return out;
}

}  // namespace nmc
