// SPDX-License-Identifier: MIT
#include "model/response/frequencyfile.h"

#include <numbers>
#include <vector>

#include "model/recording/numbertext.h"
#include "model/response/frequencyresponse.h"

namespace nmc {

std::string frequencyCsv(std::span<const FrequencyPoint> points) {
    std::vector<std::complex<double>> closed;
    std::vector<std::complex<double>> open;
    for (const FrequencyPoint& point : points) {
        closed.push_back(point.closed);
        open.push_back(point.open());
    }
    const std::vector<double> closedPhases = phases(closed);
    const std::vector<double> openPhases = phases(open);
    std::string out = "frequency_hz,closed_db,closed_deg,closed_doubt,open_db,open_deg\n";
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
