// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Nothing of its own: the precompiled headers that the test programs share belong to some target.
