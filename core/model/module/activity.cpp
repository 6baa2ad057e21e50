// SPDX-License-Identifier: MIT
#include "model/module/activity.h"

namespace nmc {

Severity severityOf(Activity activity) {
    switch (activity) {
        case Activity::Tripped:
        case Activity::PowerLost:
        case Activity::Unresponsive:
        case Activity::Restarted:
        case Activity::Overheated:
        case Activity::WentOff:
            return Severity::Fault;
        case Activity::NotAsked:
        case Activity::NoPower:
        case Activity::PwmMode:
        case Activity::MaybeOff:
        case Activity::MaybeMoving:
        case Activity::Turned:
        case Activity::Limited:
        case Activity::StoppedByLimit:
        case Activity::EstopActive:
            return Severity::Attention;
        case Activity::Unknown:
        case Activity::ServoOff:
        case Activity::AmplifierOff:
        case Activity::Holding:
        case Activity::Accelerating:
        case Activity::AtSpeed:
        case Activity::Decelerating:
        case Activity::OnPath:
        case Activity::Ready:
            return Severity::Normal;
    }
    return Severity::Normal;
}

}  // namespace nmc
