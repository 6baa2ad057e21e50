// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/settings/machine.h"
#include "widgets/common/filedialog.h"

namespace nmc {

struct AxisCopy;
struct KeptResponse;
struct PathColumn;
struct ResponseRecord;
struct SuggestionTask;

/// What the user requests of the program, wherever in the window: pages and dialogs emit it here, and nothing
/// between them and the program passes it on. One for each window. GUI thread.
class Requests : public QObject {
    Q_OBJECT
    Q_MOC_INCLUDE("model/machinefile/axiscopy.h")
    Q_MOC_INCLUDE("model/path/pathfile.h")
    Q_MOC_INCLUDE("widgets/response/modelbox.h")

public:
    using QObject::QObject;

signals:
    // ---- of a module ----

    void intent(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// On press and every 100 ms while held; each press has a number of its own.
    void hold(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// The user has changed the settings of an axis; this sends nothing.
    void axisEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

    /// Positions are read and typed from this work offset, which was chosen while home was there, or by the
    /// counter; nothing is sent.
    void workOffset(nmc::ModuleIndex module, const std::optional<nmc::WorkOffset>& offset,
                    const std::optional<std::int32_t>& home);

    // ---- of the chain ----

    /// Another search for the chain; nothing is reset.
    void scan();
    /// Connects again to the port that is open read-only, with commands allowed.
    void connectFully();
    /// The window asks the user first.
    void restart();
    /// The modules found now are expected from now on.
    void acceptChain();
    void address(nmc::ModuleIndex module, nmc::BusAddress address);
    void groupChange(const nmc::bus::GroupChange& change);
    void groupCommand(const nmc::bus::GroupCommand& command);
    /// The user has named the group; nothing is sent.
    void groupNamed(quint8 group, const QString& name);
    void rate(quint32 baud);

    // ---- of axes together ----

    /// The differences are shown first; nothing is sent before the user applies them.
    void copyAxis(const nmc::AxisCopy& copy);
    void homeAll();
    void homeOrderEdited(const std::vector<nmc::ModuleIndex>& order);
    /// Points and sequences have been edited; nothing is sent.
    void programEdited(const nmc::Program& program);
    void goToPoint(const std::string& point);
    /// The same, for a place that is not one of the points.
    void goToPlace(const nmc::Point& place);
    void startSequence(const std::string& sequence, std::size_t row, bool singleStep);
    void pauseSequence();
    void resumeSequence();
    void stepSequence();
    void stopSequence();
    /// Simulates a run of the sequence; nothing is sent.
    void foresee(const std::string& sequence, std::size_t row);
    void foresightDropped();
    /// PathsPage shows the path, or why it cannot be read.
    void openPath(const QString& file, const std::vector<nmc::PathColumn>& axes);

    // ---- of tuning ----

    /// Into the fields of the selected module, which is that of the run they come from; nothing is sent.
    void stageGains(const nmc::servo::SetGain& gains);
    /// A motor model of the module, which ModelBox::showMotor() shows.
    void identify(nmc::ModuleIndex module, const std::vector<nmc::ResponseRecord>& runs);
    /// Emitted with every move of a slider; the calculation takes some tenths of a second.
    /// ModelBox::showSuggestion() shows the gains.
    void suggest(const nmc::SuggestionTask& task);
    /// A step response to compare with others.
    void showRun(const nmc::KeptResponse& run);
    /// ResponsePage::runs() have changed other than by showKept() or clearRuns(), and must be stored.
    void storeRuns();

    // ---- of other programs (docs/api.md) ----

    void letProgramsIn(bool on);
    /// Takes back the right to move motors.
    void endProgramControl();
    /// To the program that opens this path (docs/lending.md).
    void lend(const QString& path);
    /// The program may continue after a stop.
    void letProgramThrough();
    void endLending();

    // ---- of the program ----

    /// A file is to be saved: packets, messages, step responses, what the scope shows, and the like. The user
    /// has agreed to replace the file if it exists.
    void save(const QString& path, const nmc::FileContent& content);
    /// One page; the receiver asks for a printer.
    void print(const QByteArray& pdf);
};

}  // namespace nmc
