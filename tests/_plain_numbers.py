"""For tests that write numbers into files by repr(): numpy's own numbers without their type.

From numpy 2 on repr(numpy.float64(0.5)) is "np.float64(0.5)"; before, and after this import, it is "0.5".
"""

import numpy as np

if np.lib.NumpyVersion(np.__version__) >= "2.0.0":
    np.set_printoptions(legacy="1.25")
