// Four comparisons around the receiver, weighted bilinearly, each texel compared with a depth of its own, and read with the others.

import package::sampling::kernel_box::umbrage_kernel;
import package::sampling::quads::umbrage_filter;
