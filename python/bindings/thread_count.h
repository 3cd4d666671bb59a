// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge::python {

/// Threads for a batch: `asked`, or for 0 one for each CPU that the process may use. Throws
/// InvalidParameterError for a number below 0 or above kMostBatchThreads.
int batch_threads(int asked);

}  // namespace raygauge::python
