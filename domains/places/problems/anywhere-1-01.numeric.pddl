; Problem anywhere-1-01 of the learned domain places, in numbers.
; How it came about: anywhere, drawn with seed 2; draw 1.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-1-01)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-10
    m-0010-lift-item-01 m-0010-lift-down-item-01 m-1001c-lift-item-01 m-1001c-lift-down-item-01 m-0000b-item-01 m-0100-item-01 m-0100c-item-01 m-0110c-item-01 m-1110c-item-01 m-0101c-item-01 m-1011-item-01 m-1001c-item-01 m-1010-item-01 m-0111c-item-01 m-1111-item-01 m-1000-item-01 m-0001b-item-01 m-0011-item-01 m-1101-item-01 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.8149, -0.1249, 0.0175) m at first
    (lifts item-01 m-0010-lift-item-01)
    (lowers m-0010-lift-down-item-01 m-0010-lift-item-01)
    (lifts item-01 m-1001c-lift-item-01)
    (lowers m-1001c-lift-down-item-01 m-1001c-lift-item-01)
    (pushes item-01 m-0000b-item-01) (pushes item-01 m-0100-item-01) (pushes item-01 m-0100c-item-01) (pushes item-01 m-0110c-item-01) (pushes item-01 m-1110c-item-01) (pushes item-01 m-0101c-item-01) (pushes item-01 m-1011-item-01) (pushes item-01 m-1001c-item-01) (pushes item-01 m-1010-item-01) (pushes item-01 m-0111c-item-01) (pushes item-01 m-1111-item-01) (pushes item-01 m-1000-item-01) (pushes item-01 m-0001b-item-01) (pushes item-01 m-0011-item-01) (pushes item-01 m-1101-item-01)
    (= (x item-01) 4649) (= (y item-01) 1751) (= (z item-01) 0)
    (= (along-x m-0010-lift-item-01) 10274) (= (along-y m-0010-lift-item-01) 10234) (= (along-z m-0010-lift-item-01) 12331)
    (= (along-x m-0010-lift-down-item-01) 10002) (= (along-y m-0010-lift-down-item-01) 9994) (= (along-z m-0010-lift-down-item-01) 7669)
    (= (along-x m-1001c-lift-item-01) 10277) (= (along-y m-1001c-lift-item-01) 9485) (= (along-z m-1001c-lift-item-01) 12000)
    (= (along-x m-1001c-lift-down-item-01) 9997) (= (along-y m-1001c-lift-down-item-01) 9994) (= (along-z m-1001c-lift-down-item-01) 8000)
    (= (along-x m-0000b-item-01) 9448) (= (along-y m-0000b-item-01) 9812) (= (along-z m-0000b-item-01) 10000)
    (= (along-x m-0100-item-01) 9225) (= (along-y m-0100-item-01) 9954) (= (along-z m-0100-item-01) 10000)
    (= (along-x m-0100c-item-01) 9384) (= (along-y m-0100c-item-01) 10214) (= (along-z m-0100c-item-01) 10000)
    (= (along-x m-0110c-item-01) 9693) (= (along-y m-0110c-item-01) 9954) (= (along-z m-0110c-item-01) 10000)
    (= (along-x m-1110c-item-01) 9811) (= (along-y m-1110c-item-01) 10149) (= (along-z m-1110c-item-01) 10000)
    (= (along-x m-0101c-item-01) 10402) (= (along-y m-0101c-item-01) 9886) (= (along-z m-0101c-item-01) 10000)
    (= (along-x m-1011-item-01) 10894) (= (along-y m-1011-item-01) 10152) (= (along-z m-1011-item-01) 10000)
    (= (along-x m-1001c-item-01) 10299) (= (along-y m-1001c-item-01) 10390) (= (along-z m-1001c-item-01) 10000)
    (= (along-x m-1010-item-01) 10103) (= (along-y m-1010-item-01) 10150) (= (along-z m-1010-item-01) 10000)
    (= (along-x m-0111c-item-01) 10391) (= (along-y m-0111c-item-01) 9590) (= (along-z m-0111c-item-01) 10000)
    (= (along-x m-1111-item-01) 10426) (= (along-y m-1111-item-01) 10018) (= (along-z m-1111-item-01) 10000)
    (= (along-x m-1000-item-01) 9954) (= (along-y m-1000-item-01) 10212) (= (along-z m-1000-item-01) 10000)
    (= (along-x m-0001b-item-01) 9910) (= (along-y m-0001b-item-01) 9704) (= (along-z m-0001b-item-01) 10000)
    (= (along-x m-0011-item-01) 10150) (= (along-y m-0011-item-01) 9630) (= (along-z m-0011-item-01) 10000)
    (= (along-x m-1101-item-01) 10002) (= (along-y m-1101-item-01) 10307) (= (along-z m-1101-item-01) 10000)
    (= (total-cost) 0) (= (cost m-0010-lift-item-01) 14) (= (cost m-0010-lift-down-item-01) 0) (= (cost m-1001c-lift-item-01) 51) (= (cost m-1001c-lift-down-item-01) 0) (= (cost m-0000b-item-01) 14) (= (cost m-0100-item-01) 7) (= (cost m-0100c-item-01) 11) (= (cost m-0110c-item-01) 4) (= (cost m-1110c-item-01) 4) (= (cost m-0101c-item-01) 14) (= (cost m-1011-item-01) 4) (= (cost m-1001c-item-01) 102) (= (cost m-1010-item-01) 11) (= (cost m-0111c-item-01) 21) (= (cost m-1111-item-01) 56) (= (cost m-1000-item-01) 120) (= (cost m-0001b-item-01) 11) (= (cost m-0011-item-01) 7) (= (cost m-1101-item-01) 11)
  )
  (:goal (and (<= (x item-01) 3298) (>= (x item-01) 2388) (<= (+ (x item-01) (y item-01)) 5374) (>= (+ (x item-01) (y item-01)) 4087) (<= (y item-01) 2343) (>= (y item-01) 1433) (<= (+ (y item-01) 312) (x item-01)) (<= (x item-01) (+ (y item-01) 1599)) (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
