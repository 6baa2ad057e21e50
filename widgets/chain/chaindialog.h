// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "model/module/linkstate.h"
#include "model/settings/machine.h"

class QTabWidget;

namespace nmc {

class DoctorPage;
class FocusKeeper;
class GroupsPage;
class RatePage;
class Requests;

/// The dialog for the chain as a whole: doctor, groups and baud rate. Not modal: the panel, including STOP
/// ALL, stays usable.
class ChainDialog : public QDialog {
    Q_OBJECT

public:
    enum Page { Doctor, Groups, Rate };

    explicit ChainDialog(Requests& requests, QWidget* parent = nullptr);

    void openAt(Page page);
    /// Emits nothing.
    void showChain(const Machine& machine, const LinkState& link);

protected:
    bool focusNextPrevChild(bool next) override;

private:
    FocusKeeper* m_focus;
    QTabWidget* m_pages;
    DoctorPage* m_doctor;
    GroupsPage* m_groups;
    RatePage* m_rate;
};

}  // namespace nmc
