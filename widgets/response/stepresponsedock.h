// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>

#include "widgets/response/stepresponsepage.h"

namespace nmc {

/// The place of the step responses, closed at first: its content is built when it is seen for the first time.
class StepResponseDock : public QDockWidget {
    Q_OBJECT

public:
    explicit StepResponseDock(QWidget* parent = nullptr);

    // As in StepResponsePage.
    void showModule(const PanelView& view);
    void showNothing();
    void showRun(KeptRun run) { page().showRun(std::move(run)); }

    /// The content; built if need be.
    StepResponsePage& page();
    /// In front, whatever is beside it.
    void open();

signals:
    /// The user wants it, and it may have too little room.
    void roomWanted();
    /// It can be seen, and what it shows may be old.
    void opened();
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);
    void gainsWanted(const nmc::servo::SetGain& gains);
    void saveRequested(const QString& path, const nmc::FileContent& content);

private:
    StepResponsePage* m_page = nullptr;
    bool m_seen = false;
};

}  // namespace nmc
