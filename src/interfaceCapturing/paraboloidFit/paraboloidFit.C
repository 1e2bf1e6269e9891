/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "paraboloidFit.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

constexpr label maxTerms = 6;

//- Sums of least squares
struct leastSquares
{
    label n;
    scalar A[maxTerms][maxTerms] = {};
    scalar b[maxTerms] = {};

    explicit leastSquares(const label terms)
    :
        n(terms)
    {}

    void add(const scalar row[], const scalar value, const scalar weight)
    {
        for (label i = 0; i < n; i++)
        {
            for (label j = 0; j < n; j++)
            {
                A[i][j] += weight*row[i]*row[j];
            }
            b[i] += weight*row[i]*value;
        }
    }

    //- By elimination; false if the points do not fix all
    bool solve()
    {
        scalar size[maxTerms];
        for (label i = 0; i < n; i++)
        {
            size[i] = A[i][i];
        }
        for (label i = 0; i < n; i++)
        {
            if (A[i][i] <= 1e-10*size[i])
            {
                return false;
            }
            for (label j = i + 1; j < n; j++)
            {
                const scalar f = A[j][i]/A[i][i];
                for (label k = i; k < n; k++)
                {
                    A[j][k] -= f*A[i][k];
                }
                b[j] -= f*b[i];
            }
        }
        for (label i = n - 1; i >= 0; i--)
        {
            for (label k = i + 1; k < n; k++)
            {
                b[i] -= A[i][k]*b[k];
            }
            b[i] /= A[i][i];
        }
        return true;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::paraboloidFit::length
(
    const planesAround::plane& p
) const
{
    if (!symmetry_.wedge())
    {
        return p.area/thickness_;
    }

    // As wide as the wedge there
    const scalar c = symmetry_.cosHalfAngle();
    const scalar x = mag(symmetry_.radial() & (p.x - symmetry_.origin()));
    return p.area/max(2*x*Foam::sqrt(1 - sqr(c))/c, VSMALL);
}


Foam::scalar Foam::dew::paraboloidFit::moment
(
    const planesAround::plane& p
) const
{
    return
        across_ != vector::zero
      ? sqr(length(p))/12
      : p.area/(4*constant::mathematical::pi);
}


void Foam::dew::paraboloidFit::mirrorAtAxis() const
{
    if (!symmetry_.wedge())
    {
        return;
    }
    const vector& e = symmetry_.radial();
    const scalar near = 2*length(planes_[0]);
    const auto radius = [&](const planesAround::plane& p)
    {
        return e & (p.x - symmetry_.origin());
    };
    if (radius(planes_[0]) > near)
    {
        return;
    }
    const label n = planes_.size();
    for (label i = 0; i < n; i++)
    {
        if (radius(planes_[i]) < near)
        {
            planesAround::plane p(planes_[i]);
            p.x -= 2*radius(p)*e;
            p.n -= 2*(p.n & e)*e;
            p.conormal = Zero;
            planes_.append(p);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::paraboloidFit::paraboloidFit(const fvMesh& mesh)
:
    mesh_(mesh),
    symmetry_(mesh),
    across_(Zero),
    thickness_(0)
{
    if (symmetry_.wedge())
    {
        across_ = symmetry_.azimuth();
    }
    else if (mesh.nGeometricD() == 2)
    {
        for (direction i = 0; i < 3; i++)
        {
            across_[i] = mesh.geometricD()[i] < 0;
        }
        thickness_ = across_ & mesh.bounds().span();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::paraboloidFit::find
(
    const planesAround& around,
    const label celli,
    scalar& K,
    planesAround::plane& surface
) const
{
    around.find(celli, planes_);
    mirrorAtAxis();

    const bool flat = across_ != vector::zero;
    const label nTerms = flat ? 3 : 6;
    if (planes_.size() < nTerms)
    {
        return false;
    }

    const planesAround::plane own = planes_[0];

    // Over the mean plane: that of a corner of a cell may be far off
    vector ez(Zero);
    scalar area = 0;
    for (const planesAround::plane& p : planes_)
    {
        ez += p.area*p.n;
        area += p.area;
    }
    ez = mag(ez) > 0.5*area ? ez/mag(ez) : own.n;

    const vector ex
    (
        normalised
        (
            flat ? across_ ^ ez
          : mag(ez.x()) < 0.6 ? vector(1, 0, 0) ^ ez
          : vector(0, 1, 0) ^ ez
        )
    );
    const vector ey(ez ^ ex);

    // In units of the largest plane
    scalar largest = 0;
    for (const planesAround::plane& p : planes_)
    {
        largest = max(largest, flat ? sqr(length(p)) : p.area);
    }
    const scalar unit = Foam::sqrt(largest);

    leastSquares fit(nTerms);
    label nUsed = 0;
    for (const planesAround::plane& p : planes_)
    {
        if ((p.n & ez) < 0.2)
        {
            continue;
        }
        nUsed++;
        const vector d((p.x - own.x)/unit);
        const vector n(p.n & ex, p.n & ey, p.n & ez);
        const scalar x = d & ex;
        const scalar y = d & ey;
        const scalar size = (flat ? length(p)/unit : p.area/largest)*n.z();
        const scalar m = moment(p)/largest;
        const scalar w = sqr(size);

        if (flat)
        {
            const scalar row[] = {1, x, sqr(x) + m*(1 - sqr(n.x()))};
            fit.add(row, d & ez, w);
        }
        else
        {
            const scalar row[] =
            {
                1, x, y,
                sqr(x) + m*(1 - sqr(n.x())),
                x*y - m*n.x()*n.y(),
                sqr(y) + m*(1 - sqr(n.y()))
            };
            fit.add(row, d & ez, w);
        }

        if (p.conormal != vector::zero)
        {
            const vector e((p.end - own.x)/unit);
            const vector nu
            (
                p.conormal & ex, p.conormal & ey, p.conormal & ez
            );
            if (flat)
            {
                const scalar row[] = {0, nu.x(), 2*nu.x()*(e & ex)};
                fit.add(row, nu.z(), w);
            }
            else
            {
                const scalar xe = e & ex;
                const scalar ye = e & ey;
                const scalar row[] =
                {
                    0, nu.x(), nu.y(),
                    2*nu.x()*xe, nu.x()*ye + nu.y()*xe, 2*nu.y()*ye
                };
                fit.add(row, nu.z(), w);
            }
        }
    }
    if (nUsed < nTerms || !fit.solve())
    {
        return false;
    }

    const scalar* a = fit.b;
    const scalar ax = a[1];
    const scalar ay = flat ? 0 : a[2];
    const scalar axx = 2*(flat ? a[2] : a[3]);
    const scalar axy = flat ? 0 : a[4];
    const scalar ayy = flat ? 0 : 2*a[5];
    const scalar N = Foam::sqrt(1 + sqr(ax) + sqr(ay));

    surface.x = own.x + a[0]*unit*ez;
    surface.n = (ez - ax*ex - ay*ey)/N;
    surface.bend =
        symm(axx*ex*ex + axy*(ex*ey + ey*ex) + ayy*ey*ey)/(unit*N);

    K =
       -(
            (1 + sqr(ay))*axx - 2*ax*ay*axy + (1 + sqr(ax))*ayy
        )/pow3(N)/unit;
    if (symmetry_.wedge())
    {
        const scalar r =
            (symmetry_.radial() & (own.x - symmetry_.origin()))
           /symmetry_.cosHalfAngle();
        K += (surface.n & symmetry_.radial())/max(r, VSMALL);
    }
    return true;
}
