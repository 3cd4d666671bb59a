% Copyright (c) 2026 The raygauge authors
% SPDX-License-Identifier: MIT

% text = rg_version (): the version of the library.
function text = rg_version ()
  text = raygauge_mex ('version');
end
