// SPDX-License-Identifier: MIT
#include "model/response/responsedrive.h"

#include <algorithm>
#include <cmath>

namespace nmc {

std::vector<DrivePoint> driveOf(const ResponseRecord& run) {
    const servo::SetGain& gains = run.taken.gains;
    const double tick = secondsPerTick(gains.sr);
    const double mostIntegral = gains.il;
    double integral = 0.0;  // the running sum over 256
    const auto pwmOf = [&](double error, double change) {
        const double wanted = (gains.kp * error + gains.kd * change + gains.ki * std::trunc(integral)) / 256;
        const double limited = std::min(std::abs(wanted), 1.0 * gains.ol);
        const double added = limited >= 1 ? gains.db.value_or(0) : 0;
        return std::copysign(std::min(limited + added, 255.0), wanted);
    };
    const double step = static_cast<double>(run.taken.goal) - run.taken.from;
    double stood = run.taken.from;
    for (const ResponsePoint& point : run.points)
        if (point.seconds <= 0)
            stood = point.position;
    const bool moves = run.taken.isMove();
    std::vector<DrivePoint> drive{{0.0, 0.0, 0.0}};
    if (!moves)
        drive = {{0.0, run.taken.goal - stood, pwmOf(run.taken.goal - stood, step)}};
    for (const ResponsePoint& point : run.points) {
        const double between = point.seconds - drive.back().seconds;
        if (between <= 0)
            continue;
        const double error = run.errorAt(point);
        const double mean = (error + drive.back().error) / 2;
        integral = std::clamp(integral + mean * between / tick / 256, -mostIntegral, mostIntegral);
        drive.push_back({point.seconds, error, pwmOf(error, (error - drive.back().error) * tick / between)});
    }
    return drive;
}

}  // namespace nmc
