// The mean of an exponential of depth, blurred before it is read (Annen et al. 2008; Salvi 2008).

import package::moments::esm::umbrage_moments_visibility;
import package::sampling::blurred::umbrage_filter;
