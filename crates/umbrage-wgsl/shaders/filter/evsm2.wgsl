// Mean and variance of an exponential of depth, blurred before they are read (Lauritzen & McCool 2008).

import package::moments::evsm2::umbrage_moments_visibility;
import package::sampling::blurred::umbrage_filter;
