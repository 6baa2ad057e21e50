// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>

namespace nmc::testing_support {

/// A folder for sockets that belongs to the test alone.
class RuntimeFolder {
public:
    RuntimeFolder() : m_before(qgetenv("XDG_RUNTIME_DIR")) {
        qputenv("XDG_RUNTIME_DIR", m_folder.path().toUtf8());
    }
    ~RuntimeFolder() { qputenv("XDG_RUNTIME_DIR", m_before); }
    RuntimeFolder(const RuntimeFolder&) = delete;
    RuntimeFolder& operator=(const RuntimeFolder&) = delete;

private:
    QByteArray m_before;
    QTemporaryDir m_folder;
};

}  // namespace nmc::testing_support
