// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>

namespace nmc {

/// Names the program; the place of the settings follows from this. Call first.
void nameApplication();

/// The settings of the program. QSettings waits, in the GUI thread, for the lock that another panel holds
/// while it writes the same file, and honours the lock of a panel that was killed in that moment for half a
/// minute. Here such a lock counts for a second: at the start and at the end, this waits for it, and in
/// between, writing is put off. GUI thread.
class PanelSettings : public QSettings {
    Q_OBJECT

public:
    /// In the user's file.
    PanelSettings();
    /// In this file, in the INI format.
    explicit PanelSettings(const QString& file);
    ~PanelSettings() override;

protected:
    bool event(QEvent* event) override;

private:
    /// True if another panel still holds the lock after this time.
    [[nodiscard]] bool isLocked(int milliseconds) const;
};

}  // namespace nmc
